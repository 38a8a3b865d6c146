#pragma once

#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// The description of a fluid for another program: one moment, atoms in the order of ids, reduced units.
struct Fluid {
    Vec3 edges;                    ///< of the periodic box, which has a corner at the origin [sigma]
    PairPotential potential;       ///< without tail
    bool tail;                     ///< whether energy and pressure include tail corrections
    std::vector<double> masses;    ///< [m]
    std::vector<Vec3> positions;   ///< in [0, L), on the grid of the box [sigma]
    std::vector<Vec3> velocities;  ///< at the same time [sigma/tau]
};

/// @pre the state has a box
/// @post positions are wrapped in the result; the state is unchanged
[[nodiscard]] Fluid fluid_of(const State& state, const PairPotential& potential, bool tail);

/// A state at the same moment; atom k has id k.
[[nodiscard]] State state_of(const Fluid& fluid, const Execution& execution = {});

/// Sum of m v^2 / 2 [epsilon].
[[nodiscard]] double kinetic_energy(const Fluid& fluid);

}  // namespace ljmd
