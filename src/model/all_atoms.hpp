#pragma once

#include "execution/ranks.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Call look(state) with the atoms of all ranks, in their order in memory; of several ranks, rank 0 alone has them and
/// looks. Collective.
template <class Look>
void look_at_all_atoms(const State& state, const Look& look) {
    const Ranks& ranks = state.execution().ranks();
    if (ranks.alone()) {
        look(state);
        return;
    }
    const State all = state.gathered();
    if (ranks.is_root()) {
        look(all);
    }
}

}  // namespace ljmd
