#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/observables/blocking.hpp"
#include "ljmd/observables/thermodynamics.hpp"

namespace ljmd {

/// One observable of a run: its mean over the sampled stages and how well it is known.
struct ObservableAverage {
    std::string name;                  ///< as in results.json
    std::string symbol;                ///< for tables
    std::string unit;                  ///< reduced, e.g. "epsilon/k_B"
    std::optional<Estimate> estimate;  ///< empty where the observable is not defined (temperature of one atom)
};

/// Averages of thermodynamic samples with standard errors by blocking.
///
/// The compressibility factor is a ratio of means, Z = <p>/(rho <T>); its error takes the correlation of p and T into
/// account (delta method).
class RunAverages {
  public:
    /// @param atoms, density  of the system, constant during the run
    RunAverages(Index atoms, double density);

    void add(const Thermodynamics& sample);
    [[nodiscard]] Index samples() const { return series_.samples(); }

    /// temperature, potential_energy, kinetic_energy, total_energy, pressure, compressibility_factor,
    /// pressure_xx ... pressure_yz, virial; empty without samples.
    [[nodiscard]] std::vector<ObservableAverage> averages() const;

    void archive(Archive& a) { a(series_); }

  private:
    [[nodiscard]] std::optional<Estimate> compressibility_factor() const;

    double density_;
    bool has_temperature_;
    BlockingAccumulator series_;
};

}  // namespace ljmd
