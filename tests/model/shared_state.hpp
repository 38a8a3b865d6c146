#pragma once

#include <memory>
#include <vector>

#include "execution/rank_team.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd::test {

/// The share that a rank has of atoms at these places, by id.
inline State share_of(const std::vector<Vec3>& positions, const Box& box, std::shared_ptr<Ranks> ranks) {
    State state(static_cast<Index>(positions.size()), box, Execution(ExecutionOptions{.ranks = std::move(ranks)}));
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        r.col(i) = box.snap(positions[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])]);
    }
    return state;
}

/// Whether two states have the same atoms in the same order, with the same properties, to the last bit.
inline bool same_atoms(const State& a, const State& b) {
    bool same = a.count() == b.count() && a.ids() == b.ids() && a.masses() == b.masses() &&
                a.positions() == b.positions() && a.velocities() == b.velocities() && a.forces() == b.forces();
    for (Index i = 0; same && i < a.count(); ++i) {
        same = a.image(i) == b.image(i);
    }
    return same;
}

}  // namespace ljmd::test
