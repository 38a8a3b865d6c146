#pragma once

#include <optional>

namespace ljmd {

/// Densities of fluid and crystal that coexist at a temperature [sigma^-3]. Between them the system separates into
/// both. Above the melting density only the crystal is stable; a fluid of such a density is metastable.
struct FreezingDensities {
    double freezing;  ///< density of the fluid
    double melting;   ///< density of the crystal
};

/// Temperatures between which freezing_densities() has values [epsilon/k_B]. The lower one is the triple point of the
/// full Lennard-Jones potential.
///
/// The upper one is our choice, because the correlation does not approach the limit of high temperatures, where the
/// densities of fluid and crystal differ by 4 %. At T = 5 its freezing density is 3 % above A rho^4 + B rho^2 = T,
/// which passes through the triple point and has that limit (Khrapak and Morfill 2011, arXiv:1104.2754). No equation of
/// state here was fitted to densities that freeze at higher temperatures.
inline constexpr double triple_point_temperature = 0.694;
inline constexpr double highest_freezing_temperature = 5.0;

/// Freezing density of the full Lennard-Jones fluid and melting density of its crystal, with b = 1/T:
///
///     rho_f = b^(-1/4) (0.90735 - 0.27120 b + 0.91784 b^2 - 1.16270 b^3 + 0.68012 b^4 - 0.15284 b^5)
///     rho_m = b^(-1/4) (0.908629 - 0.041510 b + 0.514632 b^2 - 0.708590 b^3 + 0.428351 b^4 - 0.095229 b^5)
///
/// Empty below the triple point, where there is no liquid to freeze, and above the highest temperature.
/// Source: Mastny and de Pablo (2007), doi:10.1063/1.2753149, equations 20 and 21
[[nodiscard]] std::optional<FreezingDensities> freezing_densities(double temperature);

}  // namespace ljmd
