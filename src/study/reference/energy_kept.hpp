#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ljmd {

/// How far the integration of runs at constant energy may have moved their mean temperature away from the one asked
/// for, as a part of it; the largest of all runs:
///
///     |dE/dt| t/2 / (3 T/2)   the total energy E per atom changes evenly over the time t, and goes into the velocities
///     + time_step_error       by which temperatures of velocities and of configurations differ
///
/// Runs under a thermostat need no such measure: their temperature is held, and only configurations count there.
/// @param runs  directories of finished runs  @throws DataError
[[nodiscard]] double temperature_uncertainty(const std::vector<std::filesystem::path>& runs, double temperature);

/// Transport coefficients change by about twice as much, in parts: below it, that is little beside their errors.
inline constexpr double noticeable_uncertainty = 0.005;
/// Above it no transport coefficient is given.
inline constexpr double largest_uncertainty = 0.02;

/// What it means for transport coefficients; empty if it is not noticeable.
[[nodiscard]] std::string energy_warning(double uncertainty);

}  // namespace ljmd
