#pragma once

#include <cstddef>

#include "execution/loops.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Replace the velocity v of each atom by `change(v, mass, id)`. The energy difference is counted as heat.
template <class Change>
void change_velocities(State& state, const Change& change) {
    auto velocities = state.write_velocities();
    const std::vector<double>& masses = state.masses();
    const std::vector<Index>& ids = state.ids();
    state.bath.front() += sum_over(state.execution(), state.count(), [&](Index i) {
        const auto k = static_cast<std::size_t>(i);
        const Vec3 before = velocities.col(i);
        const Vec3 after = change(before, masses[k], ids[k]);
        velocities.col(i) = after;
        return 0.5 * masses[k] * (after.squaredNorm() - before.squaredNorm());
    });
}

/// Multiply all velocities by a factor. The energy difference is counted as heat.
/// @param kinetic_energy  of the state before
inline void scale_velocities(State& state, double factor, double kinetic_energy) {
    auto velocities = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) { velocities.col(i) *= factor; });
    state.bath.front() += (factor * factor - 1.0) * kinetic_energy;
}

}  // namespace ljmd
