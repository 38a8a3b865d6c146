#pragma once

#include <string_view>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/neighbors/search_statistics.hpp"
#include "neighbors/cell_grid.hpp"
#include "neighbors/ghost_exchange.hpp"
#include "neighbors/pair_visit.hpp"

namespace ljmd {

/// Linked cells without a neighbour list: atoms are sorted into cells at every evaluation, and all atoms of the cells
/// around an atom are candidates. See PairSearch for the contract.
/// Source: Quentrec and Brot (1973), doi:10.1016/0021-9991(73)90046-6; Hockney and Eastwood (1981).
class LinkedCells {
  public:
    static constexpr std::string_view name = "cells";

    void prepare(State& state, double cutoff);

    [[nodiscard]] Index part_count(const State& state) const { return EqualParts::count(state.count()); }
    [[nodiscard]] AtomRange atoms_of(const State& state, Index part) const {
        return EqualParts::atoms(part, state.count());
    }
    template <class Visit>
    void for_each_candidate(const State& state, Index part, Visit&& visit) const {
        const auto all = state.positions_and_ghosts();
        const AtomRange atoms = atoms_of(state, part);
        for (Index i = atoms.first; i < atoms.last; ++i) {
            const Vec3 r = all.col(i);
            grid_.for_each_run(grid_.cell_at(r), [&](CellGrid::Run run) {
                for (std::int32_t k = run.first; k < run.last; ++k) {
                    const Index j = grid_.order()[static_cast<std::size_t>(k)];
                    if (j != i) {
                        const auto other = all.col(j);
                        visit(PairVisit{i, j, r[0] - other[0], r[1] - other[1], r[2] - other[2], false});
                    }
                }
            });
        }
    }

    [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

    /// The statistics are all that outlives an evaluation.
    void archive(Archive& a, State& /*state*/, double /*cutoff*/) { a(statistics_); }

  private:
    CellGrid grid_;
    GhostExchange ghosts_;
    SearchStatistics statistics_;
};

}  // namespace ljmd
