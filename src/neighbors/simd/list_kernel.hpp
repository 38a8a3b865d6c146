#pragma once

#include <cstdint>

#include "ljmd/core/simd_levels.hpp"
#include "ljmd/neighbors/cell_grid.hpp"

namespace ljmd {

/// Points among which neighbours are sought, in units of FixedPoint. Rounding them to single precision moves each
/// coordinate by at most 16 units.
template <class Real, class Integer>
struct PointArrays {
    Real* x;
    Real* y;
    Real* z;
    Integer* index;
};
using Candidates = PointArrays<float, std::int32_t>;
using ConstCandidates = PointArrays<const float, const std::int32_t>;

/// Kernels read and write whole vectors: behind what they are asked for there must be so many numbers more.
inline constexpr int list_kernel_slack = 16;

/// Builds lists.
struct ListKernel {
    /// Copy the points of some runs, one after the other, and fill up the last vector with points that are near nobody.
    /// @return how many there are, without the filling
    /// @pre room in `to` for all of them and list_kernel_slack more, and as many in `from` behind each run
    int (*gather)(const ConstCandidates& from, const CellGrid::Run* runs, int run_count, const Candidates& to);

    /// Write 4 j for all points j whose squared distance from (x, y, z) is below `range2`, but for `self`. Squared
    /// distances are computed in single precision, their relative error is below 5e-7.
    /// @param candidates  what gather() wrote, so many as it said
    /// @param range2      in units of FixedPoint, squared
    /// @return how many were written
    /// @pre room at `out` for as many as there are candidates, and list_kernel_slack more
    int (*neighbors_of)(const Candidates& candidates, int count, float x, float y, float z, std::int32_t self,
                        float range2, std::int32_t* out);
};

/// The one compiled for a level; the level must be usable here.
[[nodiscard]] inline ListKernel list_kernel(SimdLevel level) {
    return simd::compiled_for<ListKernel>(level);
}

}  // namespace ljmd
