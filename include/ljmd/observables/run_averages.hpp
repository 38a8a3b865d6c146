#pragma once

#include <optional>
#include <vector>

#include "ljmd/observables/blocking.hpp"
#include "ljmd/observables/observable_average.hpp"
#include "ljmd/observables/thermodynamics.hpp"

namespace ljmd {

/// What is held constant while samples are taken.
enum class Ensemble {
    constant_energy,    ///< one stage of Newton's equations
    canonical,          ///< one stage with a canonical thermostat
    constant_pressure,  ///< the volume fluctuates
    none                ///< anything else: only means have a meaning
};

/// Averages of thermodynamic samples with standard errors by blocking.
///
/// The compressibility factor is a ratio of means, Z = <p>/(<rho> <T>); its error takes the correlation of the three
/// into account (delta method). Fluctuations give the heat capacity: at constant energy those of the temperature, in
/// the canonical ensemble those of the total energy e per atom,
///
///     c_v = f/(2 N)/(1 - (f/2)(<T^2>/<T>^2 - 1)),   f = 3 N - 3
///     c_v = N (<e^2> - <e>^2)/<T>^2
///
/// Source of the first: Lebowitz, Percus and Verlet (1967), doi:10.1103/PhysRev.153.250
class RunAverages {
  public:
    /// @param ensemble  that all samples are from
    RunAverages(Index atoms, Ensemble ensemble);

    void add(const Thermodynamics& sample);
    [[nodiscard]] Index samples() const { return series_.samples(); }

    /// temperature, potential_energy, kinetic_energy, total_energy, pressure, compressibility_factor, heat_capacity_cv
    /// where fluctuations tell it, density where it fluctuates, pressure_xx ... pressure_yz, virial; empty without
    /// samples.
    [[nodiscard]] std::vector<ObservableAverage> averages() const;

    void archive(Archive& a) { a(series_); }

  private:
    [[nodiscard]] std::optional<Estimate> compressibility_factor() const;
    [[nodiscard]] std::optional<Estimate> heat_capacity() const;
    [[nodiscard]] std::optional<Estimate> heat_capacity_at_constant_energy() const;
    [[nodiscard]] std::optional<Estimate> heat_capacity_at_constant_temperature() const;

    double atoms_;
    double degrees_of_freedom_;
    Ensemble ensemble_;
    BlockingAccumulator series_;
};

}  // namespace ljmd
