#pragma once

#include <optional>

namespace ljmd {

/// Densities of fluid and crystal that coexist at a temperature [sigma^-3]. Between the two the system separates into
/// both; above the melting density the crystal alone is stable, and a fluid at such a density is metastable.
struct FreezingDensities {
    double freezing;  ///< of the fluid
    double melting;   ///< of the crystal
};

/// The temperatures at which freezing_densities() has values [epsilon/k_B]: from the triple point of the full
/// Lennard-Jones potential up.
///
/// The upper end is ours: the correlation does not go over into the limit of high temperatures, where fluid and crystal
/// differ in density by 4 %. At T = 5 its freezing density is 3 % above A rho^4 + B rho^2 = T, which goes through the
/// triple point and has that limit (Khrapak and Morfill 2011, arXiv:1104.2754); no equation of state here was fitted to
/// densities that freeze at higher temperatures.
inline constexpr double triple_point_temperature = 0.694;
inline constexpr double highest_freezing_temperature = 5.0;

/// Where the full Lennard-Jones fluid freezes and its crystal melts, with b = 1/T:
///
///     rho_f = b^(-1/4) (0.90735 - 0.27120 b + 0.91784 b^2 - 1.16270 b^3 + 0.68012 b^4 - 0.15284 b^5)
///     rho_m = b^(-1/4) (0.908629 - 0.041510 b + 0.514632 b^2 - 0.708590 b^3 + 0.428351 b^4 - 0.095229 b^5)
///
/// Empty below the triple point, where there is no liquid that could freeze, and above the highest temperature.
/// Source: Mastny and de Pablo (2007), doi:10.1063/1.2753149, equations 20 and 21
[[nodiscard]] std::optional<FreezingDensities> freezing_densities(double temperature);

}  // namespace ljmd
