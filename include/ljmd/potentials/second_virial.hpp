#pragma once

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Second virial coefficient [sigma^3] of a truncated potential, by GSL quadrature:
///
///     B2(T) = -2 pi * integral from 0 to rc of (exp(-u(r)/T) - 1) r^2 dr,   Z = 1 + B2 rho + O(rho^2).
///
/// @pre temperature > 0
/// @throws PhysicsError  the integral does not converge, because u falls without bound towards r = 0 (Buckingham)
/// Source: J. O. Hirschfelder, C. F. Curtiss, R. B. Bird, Molecular Theory of Gases and Liquids (1954), section 3.1.
[[nodiscard]] double second_virial_coefficient(const PairPotential& potential, double temperature);

/// Second virial coefficient of the formula without truncation, integrated to infinity.
[[nodiscard]] double untruncated_second_virial_coefficient(const PairPotential& potential, double temperature);

/// Boyle temperature: B2 = 0 for the formula without truncation, so that the dilute gas is ideal to second order.
/// @throws PhysicsError unless the formula has both attraction and repulsion
[[nodiscard]] double boyle_temperature(const PairPotential& potential);

}  // namespace ljmd
