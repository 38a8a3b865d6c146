#pragma once

#include <filesystem>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// Energies and pressures of the sampled stage of a canonical run, from its thermo.csv.
struct CanonicalSeries {
    std::vector<double> energy;    ///< U/N
    std::vector<double> pressure;  ///< rho T_0 + W/(3 V) + p_tail: at the temperature that is held, without the noise
                                   ///< of the velocities, and without the error that the time step gives them
};

/// @param temperature  T_0, held by the thermostat
/// @throws DataError  files are missing or damaged, or no stage was sampled
[[nodiscard]] CanonicalSeries canonical_series(const std::filesystem::path& run, double density, double temperature);

/// When runs have come to equilibrium.
struct FoundEquilibration {
    Index rows;           ///< before it, in the run that takes longest
    double inefficiency;  ///< rows that count as one independent sample, the largest of all series; NaN if unknown
    double independent;   ///< independent samples of a run after it, in the run that has fewest
};

/// By detect_equilibration() of energy and pressure of each run. @pre there is a run
[[nodiscard]] FoundEquilibration found_equilibration(const std::vector<CanonicalSeries>& runs);

/// How many of its standard errors the mean of the second halves of all runs differs from the mean of the first ones:
/// large where the runs are not in equilibrium, or change their phase. @return 0 for runs too short to tell
[[nodiscard]] double difference_of_halves(const std::vector<std::vector<double>>& runs);

}  // namespace ljmd
