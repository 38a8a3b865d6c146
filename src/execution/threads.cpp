#include "execution/threads.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "ljmd/core/errors.hpp"

namespace ljmd {

int available_processors() {
#ifdef CPU_COUNT
    // A process may be restricted to some processors, e.g. by taskset or a batch system.
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
        return CPU_COUNT(&allowed);
    }
#endif
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int default_thread_count() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody writes the environment
    const char* variable = std::getenv("OMP_NUM_THREADS");
    const std::string_view text = variable != nullptr ? variable : "";
    if (text.empty()) {
        return 1;
    }
    const std::string_view first = text.substr(0, text.find(','));  // the other numbers are for nested loops
    int count = 0;
    const auto [rest, error] = std::from_chars(first.data(), first.data() + first.size(), count);
    if (error != std::errc() || rest != first.data() + first.size() || count < 1 || count > max_threads) {
        throw InputError(
            fmt::format("OMP_NUM_THREADS is '{}': allowed is a number of threads from 1 to {}", text, max_threads));
    }
    return count;
}

}  // namespace ljmd
