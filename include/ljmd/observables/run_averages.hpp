#pragma once

#include <optional>
#include <vector>

#include "ljmd/observables/blocking.hpp"
#include "ljmd/observables/observable_average.hpp"
#include "ljmd/observables/thermodynamics.hpp"

namespace ljmd {

/// Averages of thermodynamic samples with standard errors by blocking.
///
/// The compressibility factor is a ratio of means, Z = <p>/(rho <T>); its error takes the correlation of p and T into
/// account (delta method). At constant energy the fluctuations of the temperature give the heat capacity,
///
///     c_v = f/(2 N)/(1 - (f/2)(<T^2>/<T>^2 - 1)),   f = 3 N - 3
///
/// Source: Lebowitz, Percus and Verlet (1967), doi:10.1103/PhysRev.153.250
class RunAverages {
  public:
    /// @param atoms, density   of the system, constant during the run
    /// @param constant_energy  all samples are from one stage at constant energy
    RunAverages(Index atoms, double density, bool constant_energy);

    void add(const Thermodynamics& sample);
    [[nodiscard]] Index samples() const { return series_.samples(); }

    /// temperature, potential_energy, kinetic_energy, total_energy, pressure, compressibility_factor,
    /// heat_capacity_cv at constant energy, where one has such fluctuations, pressure_xx ... pressure_yz, virial; empty
    /// without samples.
    [[nodiscard]] std::vector<ObservableAverage> averages() const;

    void archive(Archive& a) { a(series_); }

  private:
    [[nodiscard]] std::optional<Estimate> compressibility_factor() const;
    [[nodiscard]] std::optional<Estimate> heat_capacity() const;

    double atoms_;
    double density_;
    double degrees_of_freedom_;
    bool constant_energy_;
    BlockingAccumulator series_;
};

}  // namespace ljmd
