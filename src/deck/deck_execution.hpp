#pragma once

#include <string>

#include "deck/run_plan.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// How to compute the system of a run. The precision is the plan's.
/// @param threads  their number; 0: default_thread_count()
/// @param simd     name of the SIMD level; empty: default_simd_level()
/// @throws InputError for a level that cannot be used here, and for wrong values of OMP_NUM_THREADS and LJMD_SIMD if
/// these are used
[[nodiscard]] ExecutionOptions execution_options(const RunPlan& plan, int threads = 0, const std::string& simd = {});

}  // namespace ljmd
