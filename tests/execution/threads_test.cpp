#include "execution/threads.hpp"

#include <string>
#include "catch.hpp"

#include "core/environment_guard.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Contains;

TEST_CASE("there is a processor and a thread") {
    CHECK(default_thread_count() >= 1);
    CHECK(available_processors() >= 1);
}

TEST_CASE("OMP_NUM_THREADS says how many threads there are by default") {
    const auto count_for = [](const std::string& text) {
        const test::EnvironmentGuard variable("OMP_NUM_THREADS", text);
        return default_thread_count();
    };
    CHECK(count_for("") == 1);
    CHECK(count_for("1") == 1);
    CHECK(count_for("3") == 3);
    CHECK(count_for("4,2") == 4);
    CHECK(count_for("4096") == max_threads);
    for (const char* wrong : {"0", "-2", "4097", "100000", "99999999999", "two", "2 threads", ",2"}) {
        const test::EnvironmentGuard variable("OMP_NUM_THREADS", wrong);
        CHECK_THROWS_WITH(default_thread_count(),
                          Contains("'" + std::string(wrong) + "'") && Contains("from 1 to 4096"));
        CHECK_THROWS_AS(default_thread_count(), InputError);
    }
}
