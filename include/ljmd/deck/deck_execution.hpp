#pragma once

#include <string>

#include "ljmd/deck/deck.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// How to compute the system of a deck. The precision is the deck's, double for few bodies.
/// @param threads  their number; 0: default_thread_count()
/// @param simd     name of the SIMD level; empty: default_simd_level()
/// @throws InputError for a level that cannot be used here, and for wrong values of OMP_NUM_THREADS and LJMD_SIMD if
/// these are used
[[nodiscard]] ExecutionOptions execution_options(const Deck& deck, int threads = 0, const std::string& simd = {});

/// Of the pair sum; double for few bodies.
[[nodiscard]] Precision precision_of(const Deck& deck);

}  // namespace ljmd
