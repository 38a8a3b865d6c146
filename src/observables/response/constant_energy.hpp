#pragma once

#include "observables/response/response_means.hpp"

namespace ljmd::response {

/// Constant energy and momentum. The volume of phase space, Omega(E, V) proportional to V^N times the integral of
/// (E - U)^(f/2) over the scaled positions, with f = 3 N - 3, gives T = Omega/Omega_E and p = Omega_V/Omega_E. Their
/// derivatives are means as well. With s = 1 - 2/f, P = -dU/dV at fixed scaled positions, the hypervirial X, and c and
/// m for the mean of (P - <P>)/T and of (P - <P>)^2/T less the part of 1/T,
///
///     theta   = 1 - s <T> <1/T> = 1/C_v          C_v of the f degrees of freedom of the motion
///     c_v     = 1/(N theta) + 3/(2 N)            the last term is the share of the centre of mass
///     gamma_V = rho + s c/theta                  c = <P/T> - <P> <1/T>
///     K_T     = rho <T> + <P> + <X>/(9 V) - V s m - V s^2 <T> c^2/theta       m = <(P - <P>)^2/T>
///
/// Exact for any number of atoms.
/// Sources: Lebowitz, Percus and Verlet (1967), doi:10.1103/PhysRev.153.250; Cheung (1977),
/// doi:10.1080/00268977700101471; with the volume of phase space: Pearson, Halicioglu and Tiller (1985),
/// doi:10.1103/PhysRevA.32.3030, and Lustig (1994), doi:10.1063/1.466446
template <class Real>
Basis<Real> constant_energy(const Means<Real>& means) {
    const double freedom = 3.0 * means.atoms - 3.0;
    const Real s = 1.0 - 2.0 / freedom;
    const Real n = means.atoms;
    const Real t = means.mean[temperature];
    const Real y = means.mean[inverse_temperature];
    const Real p = means.mean[pressure];
    const Real rho = means.density();
    // With all variances multiplied by the share: <T> <1/T> exceeds 1 by the variance of T.
    const Real theta = Real(1.0) - s * Real(Real(1.0) + means.share * Real(t * y - Real(1.0)));
    const Real c = means.covariance(inverse_pressure, inverse_temperature, pressure);
    const Real m =
        means.share * Real(means.mean[inverse_pressure_2] - Real(2.0) * p * means.mean[inverse_pressure] + p * p * y);
    const Real volume = n / rho;
    return {
        Real(1.0) / (n * theta) + Real(1.5 / means.atoms), rho + s * c / theta,
        rho * t + means.pressure() + Real(means.mean[stiffness]) - volume * s * m - volume * s * s * t * c * c / theta};
}

}  // namespace ljmd::response
