#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ljmd/core/simd.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/cell_grid.hpp"
#include "ljmd/neighbors/fixed_point.hpp"
#include "ljmd/neighbors/search_statistics.hpp"
#include "ljmd/parallel/ghost_exchange.hpp"

namespace ljmd {

/// Verlet's list: for every atom all others within cutoff + skin, found through linked cells and kept until some atom
/// has moved by more than skin/2 since. Two atoms that were farther apart than cutoff + skin are then still farther
/// apart than the cutoff, so no pair is ever missed. Checked at every evaluation, before the list is used.
///
/// For comparison with programs that do so, a list can instead be kept for a fixed number of evaluations. Nothing is
/// checked then, and pairs may be missed.
///
/// The list is full (each pair from both sides): every atom's force is its own sum, whose order the configuration
/// decides. See PairSearch for the contract.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98; Chialvo and Debenedetti (1990), doi:10.1016/0010-4655(90)90007-N.
class VerletList {
  public:
    static constexpr std::string_view name = "verlet-list";

    /// @param skin   [sigma], >= 0
    /// @param every  keep each list for that many evaluations (>= 1), whatever the atoms do; none: by displacement
    explicit VerletList(double skin, std::optional<Index> every = std::nullopt) : skin_(skin), every_(every) {}

    /// Which kernel builds lists, and to a multiple of how many entries those of each atom are filled up; takes effect
    /// at the next rebuild. @pre level is usable here; 1 <= lanes <= 16
    void prepare_for(SimdLevel level, int lanes);

    void prepare(State& state, double cutoff);

    template <class Visit>
    void for_each_candidate(const State& state, Index i, Visit&& visit) const {
        const auto all = state.positions_and_ghosts();
        const Vec3 r = all.col(i);
        const Block& block = blocks_[static_cast<std::size_t>(i / atoms_per_block)];
        const auto k = static_cast<std::size_t>(i % atoms_per_block);
        for (std::uint32_t e = block.starts[k]; e < block.starts[k + 1]; ++e) {
            const Index j = point(block.entries[e]);
            if (j == all.cols()) {
                break;  // the filling
            }
            const auto other = all.col(j);
            visit(j, r[0] - other[0], r[1] - other[1], r[2] - other[2]);
        }
    }

    /// The lists of consecutive atoms, for kernels.
    static constexpr Index atoms_per_block = 64;
    struct Block {
        /// 4 j for each neighbour j (the place of its x where four numbers are kept a point), as an unsigned number.
        /// The lists of each atom are filled up with State::far_point(), and none is empty.
        std::vector<std::int32_t> entries;
        std::array<std::uint32_t, atoms_per_block + 1> starts;
    };
    [[nodiscard]] std::span<const Block> blocks() const { return blocks_; }

    /// Of the points when the list was built, and good until it is built again.
    [[nodiscard]] const FixedPoint& fixed_point() const { return fixed_point_; }

    [[nodiscard]] double skin() const { return skin_; }
    [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

    /// Number of neighbours of all atoms: twice the number of pairs within cutoff + skin at the last rebuild.
    [[nodiscard]] Index entries() const { return entries_; }

  private:
    static Index point(std::int32_t entry) { return Index{static_cast<std::uint32_t>(entry)} / 4; }

    /// Points as the kernel wants them, with room for whole vectors behind them.
    struct CandidateArrays {
        void resize(std::size_t size);
        std::array<std::vector<float>, 3> places;  ///< in units of fixed_point_
        std::vector<std::int32_t> index;
    };

    /// True when no atom has moved by more than skin/2 since the list was built for this cutoff and box.
    [[nodiscard]] bool still_valid(const State& state, double cutoff) const;
    [[nodiscard]] bool nothing_moved_too_far(const State& state) const;
    void build(const State& state, double cutoff);
    void find_candidates(const ConstVectorView& points);
    /// @return {neighbours, distance tests}
    std::array<Index, 2> fill_block(Block& block, const State& state, Index first, Index last, double range) const;

    double skin_;
    std::optional<Index> every_;
    SimdLevel level_ = default_simd_level();
    int lanes_ = 1;
    Index age_ = 0;  ///< evaluations since the last rebuild
    double built_for_cutoff_ = -1.0;
    Vec3 built_for_edges_ = Vec3::Zero();
    Index built_for_order_ = -1;
    int built_for_lanes_ = 0;
    CellGrid grid_;
    GhostExchange ghosts_;
    FixedPoint fixed_point_;
    CandidateArrays candidates_;       ///< all points, in the order of the cells
    AlignedVector<double> reference_;  ///< positions when the list was built, 4 numbers each
    std::vector<Block> blocks_;
    Index entries_ = 0;
    SearchStatistics statistics_;
};

}  // namespace ljmd
