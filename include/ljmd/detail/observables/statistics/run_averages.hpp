#pragma once

#include <optional>
#include <vector>

#include "ljmd/detail/observables/ensemble.hpp"
#include "ljmd/detail/observables/statistics/jackknife_blocks.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// How fast baths exchange with the system.
struct Baths {
    double exchange = 0.0;  ///< samples in which the kinetic energy relaxes; 0 if there is no such time
    double volume_mobility =
        0.0;  ///< relative change of the volume in a sample per pressure [sigma^3/epsilon]; 0: none
};

/// Averages of thermodynamic samples with standard errors by block averaging.
///
/// The compressibility factor is a ratio of means, Z = <p>/(<rho> <T>); its error includes the correlations of the
/// three (delta method).
///
/// Pairs that form and part slowly, as in a gas, are hidden in the pressure below the noise of the motion, in the
/// virial and in Z below the noise of collisions. They show in the potential energy. So all that the forces contribute
/// to counts it among its parts (BlockingAccumulator): its error is from blocks as long as those that the potential
/// energy needs, and a guess if the potential energy's is one. A short run of a gas has so few of these pairs
/// that they do not show there either. Such a run is short beside the time between collisions, and the shear stress,
/// which collisions make relax, tells so: blocks four times as long give p_xy, p_xz and p_yz together an error that is
/// more than 1.6 times as large. (At least 16 blocks remain.) All that the forces contribute to is then a guess.
///
/// Energy that a bath exchanges slowly is hidden likewise, and shows in the total energy. It is a part of all averages
/// where its error is more than 1.5 times the potential energy's, as is the density where the volume fluctuates.
/// With fewer than 24 independent samples of these the errors are guesses. If the bath takes up a deviation of the
/// kinetic energy in k_K samples, the total one needs k = k_K var(E)/var(K), since the potential energy shares what the
/// bath gives. Of n samples n_E = n/(2 k) are then independent, or fewer, and the error of a mean x is at least the
/// error of the part that follows the energy,
///
///     |cov(x, E)|/(var(E) n_E)^(1/2)
///
/// A barostat that changes the volume by d(ln V)/dt = m (p - p_0) lets it relax in kappa/m, with kappa = var(V)/(V T).
/// So n_V = n m dt/(2 kappa) samples of the density are independent, or fewer, and the same holds with the density in
/// place of E, and 32 of 24.
///
/// A series alone does not know that it is short: those that look long enough are those with too small an error.
///
/// At constant energy the total energy samples nothing. It begins with what the integrator makes of the first step, so
/// its mean differs from the energy of the start by about as much as it fluctuates: its error is its standard
/// deviation, and it has no number of independent samples.
///
/// The heat capacity at constant volume follows from fluctuations: of the temperature at constant
/// energy, of the potential energy u per atom in the canonical ensemble. It includes the 3/2 of the motion of all N
/// atoms.
///
///     c_v = 1/(N (1 - (1 - 2/f) <T> <1/T>)) + 3/(2 N),   f = 3 N - 3
///     c_v = N (<u^2> - <u>^2)/<T>^2 + 3/2
///
/// The first formula is exact for the f degrees of freedom of the motion; 3/(2 N) is the share of the centre of mass.
/// The second one holds whether or not the thermostat conserves momentum.
/// Its error is the larger one of those by block averages, to first order, and by a jackknife over 32 to 64 blocks. A
/// run that is not long
/// compared with the correlation times underestimates variances by about 1/n, with n the number of independent samples.
/// This is part of the error. If there are too few independent samples, or if the error is a guess, there is no value.
///
/// In a very dilute gas most samples have no two atoms within the cutoff. U, W and Z - 1 then come from few encounters,
/// consecutive samples with a virial. Block averages cannot tell few long encounters from
/// many short ones. With fewer than 16 encounters the errors of U, W and Z are marked as guesses; without any, Z has no
/// value.
/// Source of the first formula: Pearson, Halicioglu and Tiller (1985), doi:10.1103/PhysRevA.32.3030
class RunAverages {
  public:
    /// @param ensemble  of all samples
    /// @param external_energy  whether the samples have one
    RunAverages(Index atoms, Ensemble ensemble, bool external_energy = false, const Baths& baths = {});

    void add(const Thermodynamics& sample);
    [[nodiscard]] Index samples() const { return series_.samples(); }

    /// temperature, potential_energy, kinetic_energy, total_energy, pressure, compressibility_factor, heat_capacity_cv
    /// if fluctuations determine it, density if it fluctuates, pressure_xx ... pressure_yz, virial; empty without
    /// samples. Observables without a value, such as temperature and pressure of a single atom, have a remark instead.
    [[nodiscard]] std::vector<ObservableAverage> averages() const;

    /// Means of temperature, potential energy per atom and pressure, in this order. @pre samples() > 0
    [[nodiscard]] Vec3 means_of_state() const;

    /// Estimate of a value computed from these three. @param gradient  of the value with respect to them
    [[nodiscard]] Estimate estimate(double value, const Vec3& gradient) const;

    void archive(Archive& a) { a(series_, blocks_, encounters_, apart_, met_before_); }

  private:
    /// Estimate of a function of the means that the forces contribute to. @param gradient  with respect to all columns
    [[nodiscard]] Estimate estimate_of(double value, const Eigen::VectorXd& gradient) const;
    [[nodiscard]] std::optional<Estimate> compressibility_factor() const;
    /// Whether so few encounters were sampled that errors of what only they contribute to are not known.
    [[nodiscard]] bool met_rarely() const;
    /// Whether the run is long beside the time between collisions, as the shear stress shows it, or encounters are so
    /// rare that they are counted.
    [[nodiscard]] bool knows_collisions() const;
    /// With at least the error that the times of the baths make, see above.
    [[nodiscard]] Estimate with_exchange(Estimate found, const Eigen::VectorXd& gradient) const;
    /// Nothing in ensembles whose fluctuations do not determine it; without estimate but with a remark if it has no
    /// value.
    [[nodiscard]] std::optional<ObservableAverage> heat_capacity() const;
    /// Change of the heat capacity, to first order, if the variance behind it were missing altogether.
    [[nodiscard]] double heat_capacity_missed(double c) const;
    [[nodiscard]] std::optional<Estimate> heat_capacity_at_constant_energy() const;
    [[nodiscard]] std::optional<Estimate> heat_capacity_at_constant_temperature() const;
    /// The formula of the ensemble for means of the samples; NaN or below 0 if they fluctuate too much.
    [[nodiscard]] double heat_capacity_of(const Eigen::VectorXd& means) const;

    double atoms_;
    double degrees_of_freedom_;
    Ensemble ensemble_;
    bool external_energy_;
    Baths baths_;
    BlockingAccumulator series_;
    JackknifeBlocks blocks_;
    Index encounters_ = 0;     ///< runs of consecutive samples with a virial
    Index apart_ = 0;          ///< samples without: no two atoms within the cutoff
    bool met_before_ = false;  ///< the last sample had a virial
};

}  // namespace ljmd
