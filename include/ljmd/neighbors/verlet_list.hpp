#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/cell_grid.hpp"
#include "ljmd/neighbors/search_statistics.hpp"
#include "ljmd/parallel/ghost_exchange.hpp"

namespace ljmd {

/// Verlet's list: for every atom all others within cutoff + skin, found through linked cells and kept until some atom
/// has moved by more than skin/2 since. Two atoms that were farther apart than cutoff + skin are then still farther
/// apart than the cutoff, so no pair is ever missed. Checked at every evaluation, before the list is used.
///
/// The list is full (each pair from both sides): every atom's force is its own sum, whose order the configuration
/// decides. See PairSearch for the contract.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98; Chialvo and Debenedetti (1990), doi:10.1016/0010-4655(90)90007-N.
class VerletList {
  public:
    static constexpr std::string_view name = "verlet-list";

    /// @param skin  [sigma], >= 0
    explicit VerletList(double skin) : skin_(skin) {}

    void prepare(State& state, double cutoff);

    template <class Visit>
    void for_each_candidate(const State& state, Index i, Visit&& visit) const {
        const auto all = state.positions_and_ghosts();
        const Vec3 r = all.col(i);
        const std::size_t last = starts_[static_cast<std::size_t>(i) + 1];
        for (std::size_t k = starts_[static_cast<std::size_t>(i)]; k < last; ++k) {
            const Index j = neighbors_[k];
            const auto other = all.col(j);
            visit(j, r[0] - other[0], r[1] - other[1], r[2] - other[2]);
        }
    }

    [[nodiscard]] double skin() const { return skin_; }
    [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

    /// Number of entries: twice the number of pairs within cutoff + skin at the last rebuild.
    [[nodiscard]] Index entries() const { return static_cast<Index>(neighbors_.size()); }

  private:
    /// True when no atom has moved by more than skin/2 since the list was built for this cutoff and box.
    [[nodiscard]] bool still_valid(State& state, double cutoff);
    void rebuild(State& state, double cutoff);

    double skin_;
    double built_for_cutoff_ = -1.0;
    Vec3 built_for_edges_ = Vec3::Zero();
    Index built_for_order_ = -1;
    CellGrid grid_;
    GhostExchange ghosts_;
    std::vector<std::size_t> starts_;
    std::vector<std::int32_t> neighbors_;
    SearchStatistics statistics_;
};

}  // namespace ljmd
