#pragma once

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

// Totals of a system without a box. Kinetic energy and momentum are in model/velocities.hpp.

/// Total angular momentum about the origin, sum m r x v. @pre the state has no box, whose images do not conserve it
[[nodiscard]] Vec3 angular_momentum(const State& state);

/// Centre of mass, sum m r / sum m. @pre the state has no box; the masses do not sum to zero
[[nodiscard]] Vec3 centre_of_mass(const State& state);

/// Energies and momenta of a few-body system at one time: totals over all bodies, in the deck's units.
struct FewBodyTotals {
    double potential_energy;
    double kinetic_energy;
    double total_energy;
    Vec3 momentum;
    Vec3 angular_momentum;  ///< about the origin
};

/// @param potential_energy  of the state  @pre as angular_momentum()
[[nodiscard]] FewBodyTotals few_body_totals(const State& state, double potential_energy);

}  // namespace ljmd
