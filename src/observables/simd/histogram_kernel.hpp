#pragma once

#include <cstdint>

#include "ljmd/execution/simd_levels.hpp"

namespace ljmd {

/// Finds the bins of a histogram that distances in a periodic box fall into. All levels give the same bins.
struct HistogramKernel {
    /// Points whose bins are wanted: so many numbers at each of x, y, z.
    struct Points {
        const double* x;
        const double* y;
        const double* z;
        int count;
    };

    /// Pairs that are too far apart go to so many bins in turn: a number that is counted up again and again would have
    /// to be waited for.
    static constexpr int overflow_bins = 8;

    /// out[k] = floor(d_k * per_length), d_k = |r - r_k| of the nearest image, where that is below `overflow`, and
    /// overflow + k modulo overflow_bins elsewhere.
    /// @param r, edges  three numbers each
    /// @pre all coordinates in [0, L]; overflow >= 0; room for points.count numbers at `out`
    void (*bins_of)(const Points& points, const double* r, const double* edges, double per_length,
                    std::int32_t overflow, std::int32_t* out);
};

/// The one compiled for a level; the level must be usable here.
[[nodiscard]] inline HistogramKernel histogram_kernel(SimdLevel level) {
    return simd::compiled_for<HistogramKernel>(level);
}

}  // namespace ljmd
