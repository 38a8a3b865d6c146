#pragma once

#include <Eigen/Core>
#include <optional>

#include "ljmd/core/types.hpp"

namespace ljmd {

// How density and transverse currents of a fluid decay at one wave number: as heat, sound and shear do.

/// F(k, t)/F(k, 0) as a mode of heat and two of sound, whose slope at t = 0 vanishes:
///
///     A exp(-z_0 t) + (1 - A) exp(-z_s t) [cos(w_s t) + b sin(w_s t)],   b = (A z_0 + (1 - A) z_s)/((1 - A) w_s)
///
/// Towards k = 0, z_0 = D_T k^2, z_s = Gamma k^2 and w_s = c k with the adiabatic speed of sound c; beyond, they are
/// effective ones of the same form. Source: de Schepper, Cohen, Bruin, van Rijs, Montfrooij and de Graaf (1988),
/// doi:10.1103/PhysRevA.38.271
struct SoundModes {
    double heat;       ///< A, the share of the central line of S(k, w)
    double heat_rate;  ///< z_0 [1/tau]
    double damping;    ///< z_s [1/tau]
    double frequency;  ///< w_s [1/tau]

    [[nodiscard]] double correlation(double time) const;

    /// Its spectrum, 1/pi integral of correlation(t) cos(w t) over t from 0 to infinity [tau].
    [[nodiscard]] double spectrum(double angular_frequency) const;
};

/// The modes that fit a correlation function best, by least squares (Levenberg and Marquardt) from t = 0 on.
/// @param correlation  F(k, t) at t = 0, h, 2 h, ...
/// @param first        start of the frequency, (C_L(k, 0)/F(k, 0))^(1/2) [1/tau]
/// @return empty if no side peak of the fitted spectrum stands out, or there is no such fit
/// @throws ContractViolation with fewer than 8 values
[[nodiscard]] std::optional<SoundModes> fitted_sound(const Eigen::VectorXd& correlation, double spacing, double first);

/// The viscosity at a wave number, from the decay of the transverse current:
///
///     eta(k) = rho m/(k^2 integral from 0 to infinity of C_T(k, t)/C_T(k, 0) dt)
///
/// by the trapezoidal rule. Towards k = 0 it is the viscosity of Green and Kubo. Source: Palmer (1994),
/// doi:10.1103/PhysRevE.49.359
/// @param current  C_T at t = 0, h, 2 h, ...
/// @return [epsilon tau/sigma^3]; empty where more than 2 % of the integral is missing: the mean of the last tenth of
/// C_T/C_T(k, 0) is beyond 0.02
/// @throws ContractViolation with fewer than 8 values
[[nodiscard]] std::optional<double> transverse_viscosity(const Eigen::VectorXd& current, double spacing, double k,
                                                         double density);

}  // namespace ljmd
