#pragma once

#include "observables/response/response_means.hpp"

namespace ljmd::response {

/// Canonical ensemble: with U = N u the potential energy, P = -dU/dV at fixed scaled positions, and the hypervirial X,
///
///     c_v     = 3/2 + <dU^2>/(N T^2)
///     gamma_V = rho + <dU dP>/T^2
///     K_T     = rho T + <P> + <X>/(9 V) - V <dP^2>/T
///
/// They follow from derivatives of <P> = integral of P exp(-U/T) / integral of exp(-U/T) with respect to T and V. Only
/// positions enter, so that they hold whether or not the thermostat conserves momentum.
/// Source: Allen and Tildesley, Computer Simulation of Liquids, 2nd ed., equations 2.82 to 2.86; Cheung (1977),
/// doi:10.1080/00268977700101471
template <class Real>
Basis<Real> canonical(const Means<Real>& means) {
    const Real t = means.mean[temperature];
    const Real rho = means.density();
    const Real uu = means.covariance(energy_energy, energy, energy);
    const Real up = means.covariance(energy_pressure, energy, pressure);
    const Real pp = means.covariance(pressure_pressure, pressure, pressure);
    const Real n = means.atoms;
    return {Real(1.5) + n * uu / (t * t), rho + n * up / (t * t),
            rho * t + means.pressure() + Real(means.mean[stiffness]) - n * pp / (rho * t)};
}

}  // namespace ljmd::response
