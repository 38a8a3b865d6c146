#include "deck/deck_execution.hpp"

#include "execution/threads.hpp"

namespace ljmd {

ExecutionOptions execution_options(const RunPlan& plan, int threads, const std::string& simd) {
    return {.threads = threads > 0 ? threads : default_thread_count(),
            .simd = default_simd_level(simd),
            .precision = plan.precision};
}

}  // namespace ljmd
