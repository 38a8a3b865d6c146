#pragma once

#include <vector>

#include "ljmd/model/state.hpp"

namespace ljmd {

/// Periodic images of the atoms near the walls, as ghosts behind the local atoms of a State.
///
/// With them a pair search needs no minimum image: every neighbour of a local atom is a local atom or a ghost, each
/// image an entry of its own. One process exchanges with itself; this is the place where ranks would exchange with each
/// other.
class GhostExchange {
  public:
    /// Consecutive local atoms that have images next to each other.
    struct Run {
        Index first;  ///< index of the first atom
        Index count;
        Vec3 shift;  ///< whole edges [sigma]
    };

    /// Make the ghosts: of each run in turn.
    void create(State& state, std::vector<Run> runs);

    /// Move the ghosts to where their atoms are now. Exact: a ghost is its atom plus whole edges.
    /// @pre order and number of atoms unchanged since create()
    void update(State& state) const;

    /// How many ghosts create() made: a state with another number has lost them.
    [[nodiscard]] Index count() const { return count_; }

  private:
    std::vector<Run> runs_;
    std::vector<Index> places_;  ///< of each run: of its first ghost among the ghosts
    Index count_ = 0;
};

}  // namespace ljmd
