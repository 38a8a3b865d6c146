#pragma once

#include "execution/simd_levels.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Sums of cosines of coordinates. All levels give the same bits.
struct CosineKernel {
    /// sums[a] = sum over i of cos(2 pi (turns[a] r[4 i + a] - start[a])) for a = 0 to 3, i < count. Each cosine is
    /// rounded to a multiple of 2^-42, which makes an error below 3e-13, so that the sum of 1024 is exact and has no
    /// order.
    /// @param r  4 count numbers, aligned to 32 bytes
    /// @pre |turns[a] r[4 i + a] - start[a]| < 2^20
    void (*sums_of_cosines)(const double* r, Index count, const double* turns, const double* start, double* sums);
};

/// The kernel compiled for a level. @pre the level is usable here
[[nodiscard]] inline CosineKernel cosine_kernel(SimdLevel level) {
    return simd::compiled_for<CosineKernel>(level);
}

}  // namespace ljmd
