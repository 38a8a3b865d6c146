#pragma once

#include <optional>
#include <vector>

#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/observables/statistics/observable_average.hpp"
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
/// into account (delta method). Fluctuations give the heat capacity at constant volume, with the 3/2 of the motion of
/// all N atoms: at constant energy those of the temperature, in the canonical ensemble those of the potential energy u
/// per atom,
///
///     c_v = 1/(N (1 - (1 - 2/f) <T> <1/T>)) + 3/(2 N),   f = 3 N - 3
///     c_v = N (<u^2> - <u>^2)/<T>^2 + 3/2
///
/// The first is exact for f degrees of freedom of the motion, and 3/(2 N) that of the centre of mass; the second does
/// not depend on whether the thermostat conserves momentum.
/// A run that is short beside the correlations of what fluctuates sees too little of it: variances are low by one part
/// in as many as there are independent samples. That is part of the error; where these are too few, or the error is a
/// guess, there is no value.
/// Source of the first: Pearson, Halicioglu and Tiller (1985), doi:10.1103/PhysRevA.32.3030
class RunAverages {
  public:
    /// @param ensemble  that all samples are from
    RunAverages(Index atoms, Ensemble ensemble);

    void add(const Thermodynamics& sample);
    [[nodiscard]] Index samples() const { return series_.samples(); }

    /// temperature, potential_energy, kinetic_energy, total_energy, pressure, compressibility_factor, heat_capacity_cv
    /// where fluctuations tell it, density where it fluctuates, pressure_xx ... pressure_yz, virial; empty without
    /// samples. What has no value, as temperature and pressure of a single atom, has a remark instead.
    [[nodiscard]] std::vector<ObservableAverage> averages() const;

    /// Means of temperature, potential energy per atom and pressure, in this order. @pre samples() > 0
    [[nodiscard]] Vec3 means_of_state() const;

    /// A value that is computed from these three, with its error. @param gradient  of the value with respect to them
    [[nodiscard]] Estimate estimate(double value, const Vec3& gradient) const;

    void archive(Archive& a) { a(series_); }

  private:
    [[nodiscard]] std::optional<Estimate> compressibility_factor() const;
    /// Nothing where no fluctuation tells it; without estimate, but with a remark, where it has no value.
    [[nodiscard]] std::optional<ObservableAverage> heat_capacity() const;
    /// What the heat capacity loses when the variance that it follows from is low by all of itself, to first order.
    [[nodiscard]] double heat_capacity_missed(double c) const;
    [[nodiscard]] std::optional<Estimate> heat_capacity_at_constant_energy() const;
    [[nodiscard]] std::optional<Estimate> heat_capacity_at_constant_temperature() const;

    double atoms_;
    double degrees_of_freedom_;
    Ensemble ensemble_;
    BlockingAccumulator series_;
};

}  // namespace ljmd
