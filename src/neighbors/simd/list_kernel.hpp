#pragma once

#include <cstdint>

#include "ljmd/execution/simd_levels.hpp"
#include "ljmd/neighbors/candidates.hpp"
#include "ljmd/neighbors/cluster_grid.hpp"

namespace ljmd {

/// Builds lists.
struct ListKernel {
    /// Copy the points of some runs of slots, one after the other, and fill up the last vector with points that are
    /// near nobody.
    /// @return how many there are, without the filling
    /// @pre room in `to` for all of them and list_kernel_slack more, and as many in `from` behind each run
    int (*gather)(const ConstCandidates& from, const ClusterGrid::Run* runs, int run_count, const Candidates& to);

    /// Write the entries of all parts of clusters with a point whose squared distance from one of the atoms of `row` is
    /// below `range2`. Squared distances are computed in single precision, their relative error is below 5e-7.
    /// @param candidates  what gather() wrote: so many points as it said
    /// @param range2      in units of FixedPoint, squared
    /// @return how many were written
    /// @pre room at `out` for as many as there are parts, and list_kernel_slack more
    int (*parts_near)(const ConstCandidates& candidates, int count, const RowOfAtoms& row, float range2,
                      std::int32_t* out);
};

/// The one compiled for a level; the level must be usable here.
[[nodiscard]] inline ListKernel list_kernel(SimdLevel level) {
    return simd::compiled_for<ListKernel>(level);
}

}  // namespace ljmd
