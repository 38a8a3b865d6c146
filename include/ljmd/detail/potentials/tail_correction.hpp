#pragma once

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Tail corrections: what truncation removes from energy and pressure, for g(r) = 1 beyond it.
///
///     u_tail = 2 pi rho        * integral of u r^2 dr         per atom
///     p_tail = (2 pi/3) rho^2  * integral of w r^4 dr,  w = -u'/r
///
/// For Lennard-Jones cut at rc: (8/3) pi rho (rc^-9/3 - rc^-3) and (16/3) pi rho^2 (2 rc^-9/3 - rc^-3). A simulation
/// with a plain cut has no impulsive force at rc, so p_tail corrects towards the full potential.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98; Frenkel and Smit, section 3.2.2.
class TailCorrection {
  public:
    TailCorrection() = default;  ///< no correction: all zero
    explicit TailCorrection(const PairPotential& potential) : integrals_(potential.tail()) {}
    explicit TailCorrection(const TailIntegrals& integrals) : integrals_(integrals) {}

    /// Energy per atom [epsilon] at number density rho [sigma^-3].
    [[nodiscard]] double energy(double density) const;

    /// Pressure [epsilon/sigma^3].
    [[nodiscard]] double pressure(double density) const;

  private:
    TailIntegrals integrals_{0.0, 0.0};
};

}  // namespace ljmd
