#pragma once

#include <optional>
#include <string>

#include "ljmd/detail/reference/equation_of_state.hpp"
#include "ljmd/detail/reference/phase_equilibrium.hpp"

namespace ljmd {

/// Densities of vapour and liquid in equilibrium [sigma^-3].
struct SaturatedDensities {
    double vapour;
    double liquid;
};

/// The densities of coexistence just below the critical temperature. There pressures at the spinodals differ by
/// (T_c - T)^(3/2), which rounding hides, but slopes dp/drho, of the order T_c - T, keep their digits. So the two
/// conditions, equal pressure and equal chemical potential with d(mu) = dp/rho, are written as integrals of the slope
/// over the densities rho = m + d t from vapour (t = -1) to liquid (t = 1):
///
///     integral of p'(rho) dt = 0,    integral of p'(rho) t/rho dt = 0    (by the first, as 1/rho = 1/m - d t/(m rho))
///
/// and solved for the middle m and half the distance d by Newton's method, which begins at m of the spinodals and
/// sqrt(3) times their d, the solution for a cubic p(rho).
///
/// Empty where rounding of the slopes leaves less than two digits of d.
[[nodiscard]] std::optional<SaturatedDensities> saturated_near_critical(const EquationOfState& equation,
                                                                        double temperature, const Spinodals& spinodals);

/// A critical temperature or pressure beside a given one, for messages: six digits, all where these look the same.
[[nodiscard]] std::string critical_in_words(double given, double critical);

/// Why a temperature or pressure just below the critical one has no coexistence. @param quantity  "temperature"
[[nodiscard]] std::string too_near_critical(const std::string& quantity, double given, const std::string& equation,
                                            double critical);

}  // namespace ljmd
