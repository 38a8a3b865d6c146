#pragma once

#include <cstdint>
#include <optional>

#include "ljmd/model/state.hpp"

namespace ljmd {

/// Kinetic degrees of freedom of N atoms whose total momentum is zero: 3 N - 3.
[[nodiscard]] Index degrees_of_freedom(Index atoms);

/// Kinetic energy K = sum m v^2 / 2 [epsilon].
[[nodiscard]] double kinetic_energy(const State& state);

/// T = (2 K - P^2/M)/(3 N - 3) [epsilon/k_B], of the motion about the centre of mass: P = sum m v is 0 but under
/// thermostats that do not conserve it. Empty for fewer than two atoms, which have no degree of freedom.
[[nodiscard]] std::optional<double> temperature(const State& state);

/// The same of so many atoms with these K, P and M.
[[nodiscard]] std::optional<double> temperature(Index atoms, double kinetic_energy, const Vec3& momentum, double mass);

/// Total momentum sum m v [m sigma/tau].
[[nodiscard]] Vec3 total_momentum(const State& state);

/// Velocities from the Maxwell-Boltzmann distribution, total momentum removed, then scaled so that the temperature is
/// exactly T. Depends on seed and atom ids only; the order in memory, which is the order of the sums, changes no more
/// than their rounding. One atom, or T = 0, is left at rest.
/// @param target  temperature, >= 0
void draw_velocities(State& state, double target, std::uint64_t seed);

/// Subtract the velocity of the centre of mass.
void remove_momentum(State& state);

/// Multiply all velocities by sqrt(target / T): Verlet's velocity rescaling. Atoms at rest stay at rest.
void rescale_velocities(State& state, double target);

}  // namespace ljmd
