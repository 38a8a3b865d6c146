#pragma once

#include <cstdint>

#include "ljmd/core/simd_levels.hpp"
#include "ljmd/neighbors/cell_grid.hpp"

namespace ljmd {

/// Points among which neighbours are sought, in the order of the cells, in units of FixedPoint. Rounding them to single
/// precision moves each coordinate by at most 16 units.
struct Candidates {
    const float* x;
    const float* y;
    const float* z;
    const std::int32_t* entries;  ///< what the list is to hold of each
};

/// The arrays of Candidates, and what a kernel writes to, have room for so many numbers more than they hold.
inline constexpr int list_kernel_slack = 16;

/// Builds the list of one atom.
struct ListKernel {
    int lanes;  ///< points that are looked at together

    /// Write the entries of all points of some runs whose squared distance from (x, y, z) is below `range2`, but for
    /// `self`. Squared distances are computed in single precision, their relative error is below 5e-7.
    /// @param runs    none longer than `lanes`: loops of unforeseeable length would cost more than the work in them
    /// @param range2  in units of FixedPoint, squared
    /// @return how many were written
    /// @pre room at `out` for as many as the runs hold, and list_kernel_slack more
    int (*neighbors_of)(const Candidates& candidates, const CellGrid::Run* runs, int run_count, float x, float y,
                        float z, std::int32_t self, float range2, std::int32_t* out);
};

/// The one compiled for a level; the level must be usable here.
[[nodiscard]] inline ListKernel list_kernel(SimdLevel level) {
    return simd::compiled_for<ListKernel>(level);
}

}  // namespace ljmd
