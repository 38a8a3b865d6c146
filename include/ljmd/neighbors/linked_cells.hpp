#pragma once

#include <string_view>

#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/cell_grid.hpp"
#include "ljmd/neighbors/search_statistics.hpp"
#include "ljmd/parallel/ghost_exchange.hpp"

namespace ljmd {

/// Linked cells without a list: atoms are sorted into cells at every evaluation, and all atoms of the cells around are
/// candidates. See PairSearch for the contract.
/// Source: Quentrec and Brot (1973), doi:10.1016/0021-9991(73)90046-6; Hockney and Eastwood (1981).
class LinkedCells {
  public:
    static constexpr std::string_view name = "cells";

    void prepare(State& state, double cutoff);

    template <class Visit>
    void for_each_candidate(const State& state, Index i, Visit&& visit) const {
        const Vec3 r = state.positions().col(i);
        grid_.for_each_run(r, [&](std::span<const CellGrid::Entry> run) {
            for (const CellGrid::Entry& other : run) {
                if (other.index != i) {
                    visit(Index{other.index}, r[0] - other.x, r[1] - other.y, r[2] - other.z);
                }
            }
        });
    }

    [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

  private:
    CellGrid grid_;
    GhostExchange ghosts_;
    SearchStatistics statistics_;
};

}  // namespace ljmd
