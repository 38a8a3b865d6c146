#pragma once

#include <vector>

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Ghost atoms: periodic images of atoms near the walls, stored after the local atoms of a State.
///
/// With them a pair search needs no minimum image: every neighbour of a local atom is a local atom or a ghost, and each
/// image has an entry of its own. A process exchanges ghosts with itself; exchange between ranks would belong here.
class GhostExchange {
  public:
    /// Consecutive local atoms whose images are consecutive, too.
    struct Run {
        Index first;  ///< index of the first atom
        Index count;
        Vec3 shift;  ///< whole box edges [sigma]
    };

    /// Make the ghosts of all runs, one run after the other.
    void create(State& state, std::vector<Run> runs);

    /// Move the ghosts to the present positions of their atoms. Exact: a ghost is its atom plus whole box edges.
    /// @pre order and number of atoms unchanged since create()
    void update(State& state) const;

    /// Number of ghosts that create() made. A state with another number has lost them.
    [[nodiscard]] Index count() const { return count_; }

  private:
    std::vector<Run> runs_;
    std::vector<Index> places_;  ///< index of each run's first ghost among the ghosts
    Index count_ = 0;
};

}  // namespace ljmd
