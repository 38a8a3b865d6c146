#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ljmd/core/aligned_vector.hpp"
#include "ljmd/core/simd.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/candidates.hpp"
#include "ljmd/neighbors/cluster_grid.hpp"
#include "ljmd/neighbors/fixed_point.hpp"
#include "ljmd/neighbors/pair_visit.hpp"
#include "ljmd/neighbors/search_statistics.hpp"

namespace ljmd {

/// Verlet's list: for every atom all others within cutoff + skin, kept until some atom has moved by more than skin/2
/// since. Two atoms that were farther apart than cutoff + skin are then still farther apart than the cutoff, so no pair
/// is ever missed. Checked at every evaluation, before the list is used.
///
/// For comparison with programs that do so, a list can instead be kept for a fixed number of evaluations. Nothing is
/// checked then, and pairs may be missed.
///
/// What stands on the list are clusters (see ClusterGrid): of each atom, all that have a member within cutoff + skin.
/// Pairs of a tile stand there once, those of two tiles, or with an image, from both sides. So the forces on the atoms
/// of a tile are sums that one thread can do alone, in an order that the configuration decides. See PairSearch for the
/// contract.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98; Chialvo and Debenedetti (1990), doi:10.1016/0010-4655(90)90007-N.
class VerletList {
  public:
    static constexpr std::string_view name = "verlet-list";

    /// @param skin   [sigma], >= 0
    /// @param every  keep each list for that many evaluations (>= 1), whatever the atoms do; none: by displacement
    explicit VerletList(double skin, std::optional<Index> every = std::nullopt) : skin_(skin), every_(every) {}

    /// Which kernel builds lists, and how many atoms share one; takes effect at the next rebuild.
    /// @pre level is usable here  @throws ContractViolation unless 1, 2 or 4 atoms do
    void prepare_for(SimdLevel level, int atoms_per_row);

    void prepare(State& state, double cutoff);

    [[nodiscard]] Index part_count(const State& /*state*/) const { return static_cast<Index>(tiles_.size()); }
    [[nodiscard]] AtomRange atoms_of(const State& /*state*/, Index part) const { return grid_.atoms_of_tile(part); }
    template <class Visit>
    void for_each_candidate(const State& state, Index part, Visit&& visit) const;

    /// The lists of a tile's atoms. Rows are what kernels sum up at once: one, two or all of the atoms of a cluster
    /// (and fewer if slots are empty), with the clusters that any of them has on its list.
    struct Tile {
        /// Of each row, first the clusters of the tile with which pairs stand there once, all of them behind its own,
        /// then the others. Its own is not among them. Cluster or image c stands there as 12 c, the place of its first
        /// x in ClusterPositions, an unsigned number.
        std::vector<std::int32_t> entries;
        /// Of each row: where its entries begin, and where the second kind of them does; behind these, the end.
        std::vector<std::uint32_t> starts;
    };
    [[nodiscard]] int atoms_per_row() const { return built_for_atoms_per_row_; }
    [[nodiscard]] std::span<const Tile> tiles() const { return tiles_; }
    [[nodiscard]] const ClusterGrid& clusters() const { return grid_; }

    /// Of the points when the list was built, and good until it is built again.
    [[nodiscard]] const FixedPoint& fixed_point() const { return fixed_point_; }

    [[nodiscard]] double skin() const { return skin_; }
    [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

    /// A list is stored as the positions that it was built from; from these it is built again, to the last entry.
    /// @param state  with the atoms in the order that they had when the list was last used; is not changed
    /// @throws CheckpointError
    void archive(Archive& a, const State& state, double cutoff);

  private:
    /// True when no atom has moved by more than skin/2 since the list was built for this cutoff and box.
    [[nodiscard]] bool still_valid(const State& state, double cutoff) const;
    [[nodiscard]] bool nothing_moved_too_far(const State& state) const;
    void build(const State& state, double cutoff);
    /// All slots, as the kernel wants them.
    void find_candidates(const State& state);
    /// @return distance tests
    [[nodiscard]] Index fill(std::size_t tile, const State& state, double range);

    double skin_;
    std::optional<Index> every_;
    SimdLevel level_ = default_simd_level();
    int atoms_per_row_ = 1;
    Index age_ = 0;  ///< evaluations since the last rebuild
    double built_for_cutoff_ = -1.0;
    Vec3 built_for_edges_ = Vec3::Zero();
    Index built_for_order_ = -1;
    int built_for_atoms_per_row_ = 0;
    ClusterGrid grid_;
    FixedPoint fixed_point_;
    CandidateArrays candidates_;       ///< all slots
    AlignedVector<double> reference_;  ///< positions when the list was built, 4 numbers each
    std::vector<Tile> tiles_;
    SearchStatistics statistics_;
};

template <class Visit>
void VerletList::for_each_candidate(const State& state, Index part, Visit&& visit) const {
    const auto r = state.positions();
    const auto first_atoms = grid_.first_atoms();
    const Tile& tile = tiles_[static_cast<std::size_t>(part)];
    const ClusterGrid::Run clusters = grid_.tiles()[static_cast<std::size_t>(part)];
    const std::uint32_t* row = tile.starts.data();
    const auto meet = [&](Index i, const ClusterGrid::Members& others, bool once) {
        const Vec3 from = r.col(i) - others.shift;  // exact on the grid of the coordinates
        for (Index j = others.first; j < others.first + others.count; ++j) {
            visit(PairVisit{i, j, from[0] - r(0, j), from[1] - r(1, j), from[2] - r(2, j), once});
        }
    };
    for (Index c = clusters.first; c < clusters.last; ++c) {
        const Index first = first_atoms[static_cast<std::size_t>(c)];
        const Index last = first_atoms[static_cast<std::size_t>(c) + 1];
        for (Index i = first; i < last; ++i) {
            const std::uint32_t* starts = row + 2 * ((i - first) / built_for_atoms_per_row_);
            meet(i, {first, static_cast<int>(i - first), Vec3::Zero()}, false);
            meet(i, {i + 1, static_cast<int>(last - i - 1), Vec3::Zero()}, false);
            for (std::uint32_t e = starts[0]; e < starts[2]; ++e) {
                const Index other =
                    Index{static_cast<std::uint32_t>(tile.entries[e])} / (Index{3} * ClusterGrid::slots);
                meet(i, grid_.members(other), e < starts[1]);
            }
        }
        row += 2 * ((last - first + built_for_atoms_per_row_ - 1) / built_for_atoms_per_row_);
    }
}

}  // namespace ljmd
