#pragma once

#include <cstdint>

#include "execution/simd_levels.hpp"

namespace ljmd {

/// Finds the histogram bins of distances in a periodic box. All levels give the same bins.
struct HistogramKernel {
    /// Points to sort into bins: `count` coordinates at each of x, y, z.
    struct Points {
        const double* x;
        const double* y;
        const double* z;
        int count;
    };

    /// Pairs that are too far apart are counted in this many bins in turn, because repeated increments of one counter
    /// would wait for each other.
    static constexpr int overflow_bins = 8;

    /// out[k] = floor(d_k * per_length) if that is below `overflow`, with d_k = |r - r_k| of the nearest image;
    /// otherwise overflow + k modulo overflow_bins.
    /// @param r, edges  three numbers each
    /// @pre all coordinates in [0, L]; overflow >= 0; room for points.count numbers at `out`
    void (*bins_of)(const Points& points, const double* r, const double* edges, double per_length,
                    std::int32_t overflow, std::int32_t* out);
};

/// The kernel compiled for a level. @pre the level is usable here
[[nodiscard]] inline HistogramKernel histogram_kernel(SimdLevel level) {
    return simd::compiled_for<HistogramKernel>(level);
}

}  // namespace ljmd
