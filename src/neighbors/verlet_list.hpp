#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ljmd/detail/core/aligned_vector.hpp"
#include "ljmd/detail/execution/simd.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/neighbors/search_statistics.hpp"
#include "neighbors/candidates.hpp"
#include "neighbors/cluster_grid.hpp"
#include "neighbors/fixed_point.hpp"
#include "neighbors/ghost_routes.hpp"
#include "neighbors/pair_visit.hpp"
#include "neighbors/row_shape.hpp"
#include "neighbors/tile_order.hpp"

namespace ljmd {

/// Verlet list: for every atom all others within cutoff + skin, kept until a pair that is not on it may be within the
/// cutoff. While no atom has moved by more than skin/2, no such pair can be. From then on the surroundings of each atom
/// that has are searched for missing pairs, see any_pair_missed(). The list is checked at every evaluation before it is
/// used, so no pair is ever missed.
///
/// For comparison with programs that do so, a list can instead be kept for a fixed number of evaluations. Pairs may be
/// missed then. Lists on which an atom moved too far are counted when they are replaced
/// (SearchStatistics::late_rebuilds).
///
/// The list holds clusters (see ClusterGrid): for each atom, all that have a member within cutoff + skin, each pair of
/// atoms once. One thread sums the pairs of a tile, in an order that the configuration decides. Forces on its ghost
/// clusters are added to their owners afterwards, see GhostRoutes. See PairSearch for the contract.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98; Chialvo and Debenedetti (1990), doi:10.1016/0010-4655(90)90007-N.
class VerletList {
  public:
    static constexpr std::string_view name = "verlet-list";

    /// @param skin   [sigma], >= 0
    /// @param every  number of evaluations (>= 1) to keep each list for, however far atoms move; none: rebuild by
    ///               displacement
    /// @param tile   see ClusterGrid::configure()
    explicit VerletList(double skin, std::optional<Index> every = std::nullopt,
                        std::optional<Index> tile = std::nullopt)
        : skin_(skin), every_(every), tile_(tile) {}

    /// Choose the level of the kernel that builds lists (by default the level of the state's execution) and the shape
    /// of their rows. Takes effect at the next rebuild.
    /// @pre level is usable here  @throws ContractViolation unless atoms x slots is 1 x 2, 2 x 2, 2 x 4 or 4 x 4
    void prepare_for(SimdLevel level, RowShape shape);

    void prepare(State& state, double cutoff);
    /// The same, but positions of other ranks' atoms may be under way until wait_for_halo(). Only the tiles of
    /// order().with_halo() need them. Nothing else may be exchanged meanwhile, see Ranks::begin_exchange().
    void begin_preparing(State& state, double cutoff);
    void wait_for_halo(const State& state);
    [[nodiscard]] const TileOrder& order() const { return order_; }

    [[nodiscard]] Index part_count(const State& /*state*/) const { return static_cast<Index>(tiles_.size()); }
    [[nodiscard]] AtomRange atoms_of(const State& /*state*/, Index part) const { return grid_.atoms_of_tile(part); }
    template <class Visit>
    void for_each_candidate(const State& state, Index part, Visit&& visit) const;

    /// The neighbour lists of a tile: for each row (see RowShape; the last row of a cluster may be short) the cluster
    /// parts that any of its atoms has on its list.
    struct Tile {
        /// Cluster parts, by the numbers of clusters within the tile. They belong to clusters that come after the row's
        /// own, and to ghost clusters; and the upper half of the row's own cluster, if the row lies in the lower one.
        /// The part that the row lies in is not listed; its pairs are computed without an entry. Where parts are halves
        /// of clusters, parts in the half that the row lies in come first, then parts in the other half. So each half
        /// has sums of its own. The part that begins at slot k of cluster c is the entry 12 c + k, the index of its
        /// first x in TilePositions. After the last row follow list_kernel_slack entries of cluster 0, for kernels that
        /// read ahead.
        std::vector<std::int32_t> entries;
        /// Index of each row's first entry, and where parts are halves of clusters of the first entry of its second
        /// half; then the number of entries.
        std::vector<std::uint32_t> starts;
        std::vector<ClusterGrid::GhostClusters> ghosts;
        std::int32_t cluster_count = 0;  ///< ghosts included
    };
    /// Where the forces on ghost clusters belong.
    [[nodiscard]] const GhostRoutes& routes() const { return routes_; }
    [[nodiscard]] GhostRoutes& routes() { return routes_; }
    /// Work of the tiles before each one, in list entries; then the work of all. For loops in which threads share the
    /// tiles.
    [[nodiscard]] std::span<const std::int64_t> work_before() const { return work_before_; }
    [[nodiscard]] const RowShape& row_shape() const { return built_for_shape_; }
    [[nodiscard]] std::span<const Tile> tiles() const { return tiles_; }
    [[nodiscard]] const ClusterGrid& clusters() const { return grid_; }

    /// For positions as they were at the rebuild; valid until the next one.
    [[nodiscard]] const FixedPoint& fixed_point() const { return fixed_point_; }

    [[nodiscard]] double skin() const { return skin_; }
    [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

    /// Store the positions that the list was built from, or read them and build the same list again, to the last entry.
    /// @param state  with the atoms in the order that they had when the list was last used. Of several ranks, reading
    /// gives each the atoms of its tiles; else the state is not changed.
    /// @throws CheckpointError
    void archive(Archive& a, State& state, double cutoff);

  private:
    /// True if the list was built for this cutoff and box, this order of atoms, and the present shape of rows.
    [[nodiscard]] bool is_of(const State& state, double cutoff) const;
    /// True if, besides, no pair within the cutoff is missing; with a fixed schedule: if the list is young enough.
    [[nodiscard]] bool still_valid(const State& state, double cutoff);
    /// True if no atom has moved by more than skin/2.
    [[nodiscard]] bool nothing_moved_too_far(const State& state) const;
    void sort(State& state, double cutoff, State* companion = nullptr);
    void build(const State& state, double cutoff);
    /// Measure the work of the tiles, by which threads share them, and ranks at the next sort().
    void measure_work(const Execution& execution);
    /// Build the lists of a tile. @return number of distance tests
    [[nodiscard]] Index fill(std::size_t tile, const State& state, double range);

    double skin_;
    std::optional<Index> every_;
    std::optional<Index> tile_;
    std::optional<SimdLevel> level_;  ///< none: the level of the state
    RowShape shape_{2, 2};
    Index age_ = 0;  ///< evaluations since the last rebuild
    double built_for_cutoff_ = -1.0;
    Vec3 built_for_edges_ = Vec3::Zero();
    Index built_for_order_ = -1;
    RowShape built_for_shape_{0, 0};
    ClusterGrid grid_;
    FixedPoint fixed_point_;
    AlignedVector<double> reference_;  ///< positions at the rebuild, ghosts included, 4 numbers per atom
    std::vector<Tile> tiles_;
    std::vector<std::int64_t> work_before_;
    TileOrder order_;
    GhostRoutes routes_;
    SearchStatistics statistics_;
};

template <class Visit>
void VerletList::for_each_candidate(const State& state, Index part, Visit&& visit) const {
    struct Cluster {
        AtomRange atoms{0, 0};
        Vec3 shift = Vec3::Zero();
    };
    const auto r = state.positions_and_ghosts();
    const Tile& tile = tiles_[static_cast<std::size_t>(part)];
    const ClusterGrid::Run own = grid_.tiles()[static_cast<std::size_t>(part)];
    std::vector<Cluster> clusters(static_cast<std::size_t>(tile.cluster_count));  // by their numbers within the tile
    for (Index c = own.first; c < own.last; ++c) {
        clusters[static_cast<std::size_t>(c - own.first)].atoms = grid_.atoms_of_cluster(c);
    }
    for (const ClusterGrid::GhostClusters& ghosts : tile.ghosts) {
        for (Index k = 0; k < ghosts.of.length(); ++k) {
            clusters[static_cast<std::size_t>(ghosts.first + k)] = {grid_.atoms_of_cluster(ghosts.of.first + k),
                                                                    ghosts.shift};
        }
    }
    const std::uint32_t* row = tile.starts.data();
    const Index halves = ClusterGrid::slots / built_for_shape_.others;
    const auto meet = [&](Index i, const AtomRange& others, Index first_slot, const Vec3& shift) {
        const Vec3 from = r.col(i) - shift;  // exact on the coordinate grid
        for (Index j = others.first; j < others.last; ++j) {
            const bool upper = first_slot + j - others.first >= ClusterGrid::slots / 2;
            visit(PairVisit{i, j, from[0] - r(0, j), from[1] - r(1, j), from[2] - r(2, j), true, upper});
        }
    };
    for (Index c = 0; c < own.length(); ++c) {
        const auto [first, last] = clusters[static_cast<std::size_t>(c)].atoms;
        for (Index i = first; i < last; ++i) {
            const std::uint32_t* starts = row + halves * ((i - first) / built_for_shape_.atoms);
            meet(i, {i + 1, last}, i + 1 - first, Vec3::Zero());
            for (std::uint32_t e = starts[0]; e < starts[halves]; ++e) {
                const auto number = static_cast<std::size_t>(tile.entries[e] / (3 * ClusterGrid::slots));
                if (number == static_cast<std::size_t>(c)) {
                    continue;
                }
                const Index slot = tile.entries[e] % (3 * ClusterGrid::slots);
                const auto& [all, shift] = clusters[number];
                meet(i, {all.first + slot, std::min(all.last, all.first + slot + built_for_shape_.others)}, slot,
                     shift);
            }
        }
        row += halves * ((last - first + built_for_shape_.atoms - 1) / built_for_shape_.atoms);
    }
}

}  // namespace ljmd
