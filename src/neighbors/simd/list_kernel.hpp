#pragma once

#include <cstdint>

#include "execution/simd_levels.hpp"
#include "neighbors/candidates.hpp"
#include "neighbors/cluster_grid.hpp"

namespace ljmd {

/// How many parts of clusters were found: of whole clusters or their lower halves, and of their upper halves.
struct PartCounts {
    int lower;
    int upper;
};

/// Functions that build neighbour lists.
struct ListKernel {
    /// Copy the points of some runs of slots, one after the other, and fill the last vector with points out of range.
    /// @return number of points copied, without the filling
    /// @pre room in `to` for all of them and list_kernel_slack more; `from` can be read list_kernel_slack beyond each
    /// run
    int (*gather)(const ConstCandidates& from, const ClusterGrid::Run* runs, int run_count, const Candidates& to);

    /// Write the entries of all cluster parts that have a point whose squared distance from one of the atoms of `row`
    /// is below `range2`. Squared distances are computed in single precision; their relative error is below 5e-7.
    /// @param candidates  as gather() wrote them
    /// @param count       as gather() returned it
    /// @param range2      in units of FixedPoint, squared
    /// @param lower       where entries of whole clusters are written, or of their lower halves; in the order of the
    /// candidates
    /// @param upper       where entries of the upper halves are written
    /// @pre room at both for an entry per cluster, and list_kernel_slack more
    PartCounts (*parts_near)(const ConstCandidates& candidates, int count, const RowOfAtoms& row, float range2,
                             std::int32_t* lower, std::int32_t* upper);
};

/// The functions compiled for a level. @pre the level is usable here
[[nodiscard]] inline ListKernel list_kernel(SimdLevel level) {
    return simd::compiled_for<ListKernel>(level);
}

}  // namespace ljmd
