#pragma once

#include "observables/response/response_means.hpp"

namespace ljmd::response {

/// Isothermal-isobaric ensemble, in which V and the scaled positions have the density V^N exp(-(U + p_0 V)/T). With
/// H = U + p_0 V at the pressure p_0 that is held,
///
///     kappa_T = <dV^2>/(<V> T)
///     alpha_p = <dV dH>/(<V> T^2)
///     c_p     = 3/2 + <dH^2>/(N T^2)
///
/// from which K_T = 1/kappa_T, gamma_V = alpha_p/kappa_T and c_v = c_p - T alpha_p^2/(rho kappa_T).
/// Source: Allen and Tildesley, Computer Simulation of Liquids, 2nd ed., equations 2.92 to 2.96
template <class Real>
Basis<Real> isothermal_isobaric(const Means<Real>& means) {
    const Real t = means.mean[temperature];
    const Real rho = means.density();
    const Real p0 = means.held_pressure;
    const Real n = means.atoms;
    const Real vv = means.covariance(volume_volume, volume, volume);
    const Real uv = means.covariance(energy_volume, energy, volume);
    const Real uu = means.covariance(energy_energy, energy, energy);
    const Real compressibility = n * rho * vv / t;
    const Real expansion = n * rho * Real(uv + p0 * vv) / (t * t);
    const Real heat_capacity_cp = Real(1.5) + n * Real(uu + Real(2.0) * p0 * uv + p0 * p0 * vv) / (t * t);
    return {heat_capacity_cp - t * expansion * expansion / (rho * compressibility), expansion / compressibility,
            Real(1.0) / compressibility};
}

}  // namespace ljmd::response
