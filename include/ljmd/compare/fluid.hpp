#pragma once

#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// A fluid as another program is told of it: one moment, atoms in the order of their ids, reduced units.
struct Fluid {
    Vec3 edges;                    ///< of the periodic box, whose corner is the origin [sigma]
    PairPotential potential;       ///< without tail
    bool tail;                     ///< tail corrections belong to energy and pressure
    std::vector<double> masses;    ///< [m]
    std::vector<Vec3> positions;   ///< in [0, L), on the grid of the box [sigma]
    std::vector<Vec3> velocities;  ///< at the same time [sigma/tau]
};

/// @pre the state has a box
/// @post positions are wrapped, whatever they are in the state, which stays as it is
[[nodiscard]] Fluid fluid_of(const State& state, const PairPotential& potential, bool tail);

/// A state at the same moment: atom k has id k.
[[nodiscard]] State state_of(const Fluid& fluid);

/// sum of m v^2 / 2 [epsilon].
[[nodiscard]] double kinetic_energy(const Fluid& fluid);

}  // namespace ljmd
