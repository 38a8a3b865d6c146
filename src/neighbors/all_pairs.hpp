#pragma once

#include <string_view>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/neighbors/search_statistics.hpp"
#include "neighbors/pair_visit.hpp"

namespace ljmd {

/// All-pairs search: every atom against every other by minimum image, O(N^2), without cells or ghosts. It is the
/// reference for tests of the other searches, and the fastest one for a few dozen atoms. See PairSearch for the
/// contract.
class AllPairs {
  public:
    static constexpr std::string_view name = "all-pairs";

    void prepare(State& state, double /*cutoff*/) {
        state.wrap();
        ++statistics_.preparations;
    }

    [[nodiscard]] Index part_count(const State& state) const { return EqualParts::count(state.count()); }
    [[nodiscard]] AtomRange atoms_of(const State& state, Index part) const {
        return EqualParts::atoms(part, state.count());
    }
    template <class Visit>
    void for_each_candidate(const State& state, Index part, Visit&& visit) const {
        const auto r = state.positions();
        const AtomRange atoms = atoms_of(state, part);
        for (Index i = atoms.first; i < atoms.last; ++i) {
            for (Index j = 0; j < state.count(); ++j) {
                if (j != i) {
                    const Vec3 d = state.box().minimum_image(r.col(i) - r.col(j));
                    visit(PairVisit{i, j, d[0], d[1], d[2], false});
                }
            }
        }
    }

    [[nodiscard]] const SearchStatistics& statistics() const { return statistics_; }

    /// The statistics are all that outlives an evaluation.
    void archive(Archive& a, State& /*state*/, double /*cutoff*/) { a(statistics_); }

  private:
    SearchStatistics statistics_;
};

}  // namespace ljmd
