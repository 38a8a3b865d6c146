#pragma once

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"

namespace ljmd {

/// How velocities were scaled so that a stage begins at a given total energy. Energies are per atom [epsilon].
struct EnergyStart {
    double total_energy = 0.0;      ///< that was asked for: U/N + K/N, tail and external energy included
    double potential_energy = 0.0;  ///< of the configuration, with the tail and the external energy
    double kinetic_before = 0.0;
    double velocity_factor = 1.0;  ///< by which all velocities were multiplied

    void archive(Archive& a) { a(total_energy, potential_energy, kinetic_before, velocity_factor); }
};

/// Scale all velocities so that the total energy per atom is this one:
///
///     v -> v ((E - U)/K)^(1/2)
///
/// A centre of mass at rest stays at rest; the distribution of the directions and of the shares of the atoms stays as
/// it is. The energy is reached to rounding.
/// @param now  thermodynamics of the state, energy included
/// @throws PhysicsError if the energy is not above the potential energy, or if the atoms are at rest
EnergyStart scale_to_total_energy(State& state, const Thermodynamics& now, double total_energy);

}  // namespace ljmd
