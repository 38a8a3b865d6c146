#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ljmd/core/aligned_vector.hpp"
#include "ljmd/execution/simd.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/candidates.hpp"
#include "ljmd/neighbors/cluster_grid.hpp"
#include "ljmd/neighbors/fixed_point.hpp"
#include "ljmd/neighbors/pair_visit.hpp"
#include "ljmd/neighbors/row_shape.hpp"
#include "ljmd/neighbors/search_statistics.hpp"

namespace ljmd {

/// Verlet's list: for every atom all others within cutoff + skin, kept until a pair that does not stand on it may be
/// within the cutoff. As long as no atom has moved by more than skin/2 since, two that were farther apart than cutoff +
/// skin are still farther apart than the cutoff; then those around the atoms that have are looked at, see
/// any_pair_missed(). No pair is ever missed. Checked at every evaluation, before the list is used.
///
/// For comparison with programs that do so, a list can instead be kept for a fixed number of evaluations. Pairs may be
/// missed then; at its end it is counted whether an atom has moved too far (SearchStatistics::late_rebuilds).
///
/// What stands on the list are clusters (see ClusterGrid): of each atom, all that have a member within cutoff + skin,
/// each pair of atoms once. A tile's pairs are summed up by one thread, in an order that the configuration decides;
/// what its guests get is added to the forces on their owners afterwards, see Tile. See PairSearch for the contract.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98; Chialvo and Debenedetti (1990), doi:10.1016/0010-4655(90)90007-N.
class VerletList {
  public:
    static constexpr std::string_view name = "verlet-list";

    /// @param skin   [sigma], >= 0
    /// @param every  keep each list for that many evaluations (>= 1), whatever the atoms do; none: by displacement
    explicit VerletList(double skin, std::optional<Index> every = std::nullopt) : skin_(skin), every_(every) {}

    /// Which kernel builds lists, and for which rows; takes effect at the next rebuild.
    /// @pre level is usable here  @throws ContractViolation unless 1 atom meets 2 others, 2 meet 2 or 4, or 4 meet 4
    void prepare_for(SimdLevel level, RowShape shape);

    void prepare(State& state, double cutoff);

    [[nodiscard]] Index part_count(const State& /*state*/) const { return static_cast<Index>(tiles_.size()); }
    [[nodiscard]] AtomRange atoms_of(const State& /*state*/, Index part) const { return grid_.atoms_of_tile(part); }
    template <class Visit>
    void for_each_candidate(const State& state, Index part, Visit&& visit) const;

    /// The lists of a tile's atoms, for each row (see RowShape; fewer if slots are empty) the parts of clusters that
    /// any of its atoms has on its list.
    struct Tile {
        /// Parts of clusters, in the numbers that these have in the tile; of those behind the row's own and guests. Its
        /// own, whose pairs the row has, too, is not among them. Slots from k on of cluster c stand there as 12 c + k,
        /// the place of the first x in TilePositions. Behind the last row stand some of cluster 0, for those who look
        /// ahead.
        std::vector<std::int32_t> entries;
        /// Of each row: where its entries begin; behind these, the end.
        std::vector<std::uint32_t> starts;
        std::vector<ClusterGrid::Guests> guests;
        std::int32_t cluster_count = 0;  ///< with the guests
    };
    /// Guests of another tile whose owner is a tile's cluster.
    struct Away {
        std::uint32_t tile;
        std::uint32_t guests;  ///< which of that tile's
    };
    /// All that a tile has, in the order of their tiles.
    [[nodiscard]] std::span<const Away> away(Index tile) const {
        const auto t = static_cast<std::size_t>(tile);
        return std::span(away_).subspan(away_starts_[t], away_starts_[t + 1] - away_starts_[t]);
    }
    [[nodiscard]] const RowShape& row_shape() const { return built_for_shape_; }
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
    /// True when the list was built for this cutoff and box, and atoms in this order.
    [[nodiscard]] bool is_of(const State& state, double cutoff) const;
    /// True when it is, and no pair within the cutoff is missing on it, or it is young enough.
    [[nodiscard]] bool still_valid(const State& state, double cutoff) const;
    /// By more than skin/2.
    [[nodiscard]] bool nothing_moved_too_far(const State& state) const;
    void build(const State& state, double cutoff);
    /// @return distance tests
    [[nodiscard]] Index fill(std::size_t tile, const State& state, double range);
    void find_guests_owners();

    double skin_;
    std::optional<Index> every_;
    SimdLevel level_ = default_simd_level();
    RowShape shape_{2, 2};
    Index age_ = 0;  ///< evaluations since the last rebuild
    double built_for_cutoff_ = -1.0;
    Vec3 built_for_edges_ = Vec3::Zero();
    Index built_for_order_ = -1;
    RowShape built_for_shape_{0, 0};
    ClusterGrid grid_;
    FixedPoint fixed_point_;
    AlignedVector<double> reference_;  ///< positions when the list was built, 4 numbers each
    std::vector<Tile> tiles_;
    std::vector<Away> away_;                ///< tile by tile
    std::vector<std::size_t> away_starts_;  ///< of each tile, and one more
    SearchStatistics statistics_;
};

template <class Visit>
void VerletList::for_each_candidate(const State& state, Index part, Visit&& visit) const {
    const auto r = state.positions();
    const Tile& tile = tiles_[static_cast<std::size_t>(part)];
    const ClusterGrid::Run clusters = grid_.tiles()[static_cast<std::size_t>(part)];
    const std::uint32_t* row = tile.starts.data();
    const auto meet = [&](Index i, const AtomRange& others, const Vec3& shift) {
        const Vec3 from = r.col(i) - shift;  // exact on the grid of the coordinates
        for (Index j = others.first; j < others.last; ++j) {
            visit(PairVisit{i, j, from[0] - r(0, j), from[1] - r(1, j), from[2] - r(2, j), true});
        }
    };
    for (Index c = clusters.first; c < clusters.last; ++c) {
        const auto [first, last] = grid_.atoms_of_cluster(c);
        for (Index i = first; i < last; ++i) {
            const std::uint32_t* starts = row + (i - first) / built_for_shape_.atoms;
            meet(i, {i + 1, last}, Vec3::Zero());
            for (std::uint32_t e = starts[0]; e < starts[1]; ++e) {
                const std::int32_t other = tile.entries[e] / (3 * ClusterGrid::slots);
                const std::int32_t slot = tile.entries[e] % (3 * ClusterGrid::slots);
                const auto part_of = [&](Index cluster) {
                    const AtomRange all = grid_.atoms_of_cluster(cluster);
                    return AtomRange{all.first + slot, std::min(all.last, all.first + slot + built_for_shape_.others)};
                };
                if (other < clusters.length()) {
                    meet(i, part_of(clusters.first + other), Vec3::Zero());
                } else {
                    const auto behind = std::upper_bound(
                        tile.guests.begin(), tile.guests.end(), other,
                        [](std::int32_t number, const ClusterGrid::Guests& guests) { return number < guests.first; });
                    const ClusterGrid::Guests& guests = *std::prev(behind);
                    meet(i, part_of(guests.of.first + other - guests.first), guests.shift);
                }
            }
        }
        row += (last - first + built_for_shape_.atoms - 1) / built_for_shape_.atoms;
    }
}

}  // namespace ljmd
