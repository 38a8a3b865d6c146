#pragma once

#include <cstdint>
#include <optional>

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Kinetic degrees of freedom of N atoms whose total momentum is zero: 3 N - 3.
[[nodiscard]] Index degrees_of_freedom(Index atoms);

/// Kinetic energy K = sum m v^2 / 2 [epsilon].
[[nodiscard]] double kinetic_energy(const State& state);

/// Temperature of the motion about the centre of mass, T = (2 K - P^2/M)/(3 N - 3) [epsilon/k_B]. P = sum m v is 0
/// except under thermostats that do not conserve momentum, and under external forces. Empty for fewer than two atoms,
/// which have no degrees of freedom.
[[nodiscard]] std::optional<double> temperature(const State& state);

/// The same from K, P and the total mass M.
[[nodiscard]] std::optional<double> temperature(Index atoms, double kinetic_energy, const Vec3& momentum, double mass);

/// Total momentum sum m v [m sigma/tau].
[[nodiscard]] Vec3 total_momentum(const State& state);

/// Draw velocities from the Maxwell-Boltzmann distribution, remove the total momentum and scale them to the temperature
/// exactly. They depend on seed and atom ids only, and through rounding of sums on the order in memory. A single atom,
/// or T = 0, gives atoms at rest.
/// @param target  temperature [epsilon/k_B], >= 0
void draw_velocities(State& state, double target, std::uint64_t seed);

/// Velocity of the centre of mass, P/M [sigma/tau]; zero without atoms.
[[nodiscard]] Vec3 centre_velocity(const State& state);

/// Add the same velocity to all atoms.
void shift_velocities(State& state, const Vec3& by);

/// Subtract the velocity of the centre of mass.
void remove_momentum(State& state);

/// Velocity rescaling (Verlet): multiply all velocities by sqrt(target / T). Atoms at rest stay at rest.
/// @param target  temperature [epsilon/k_B], >= 0
void rescale_velocities(State& state, double target);

/// Multiply all velocities by a factor.
void scale_velocities(State& state, double factor);

}  // namespace ljmd
