#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/observables/ensemble.hpp"
#include "ljmd/detail/observables/statistics/jackknife_blocks.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/response/response_means.hpp"

namespace ljmd {

/// One configuration, as response functions need it.
struct ResponseSample {
    double temperature;  ///< of the motion about the centre of mass [epsilon/k_B]
    double energy;       ///< U/N of the potential in which the atoms move, with the energy of the tail [epsilon]
    double pressure;     ///< W/(3 V) + p_tail, without the kinetic part [epsilon/sigma^3]
    double volume;       ///< V/N [sigma^3]
    double stiffness;    ///< X/(9 V) + p_tail, see PairCurvature; anything if it is not known [epsilon/sigma^3]
};

/// Response functions from the fluctuations of one ensemble, with errors.
///
/// Each ensemble gives three of them (canonical.hpp, constant_energy.hpp and isothermal_isobaric.hpp),
/// and these the others, with m = 1:
///
///     kappa_T = 1/K_T                          isothermal compressibility    -(1/V) (dV/dp)_T
///     alpha_p = gamma_V/K_T                    thermal expansion              (1/V) (dV/dT)_p
///     c_p     = c_v + T gamma_V^2/(rho K_T)    isobaric heat capacity
///     K_S     = K_T + T gamma_V^2/(rho c_v)    adiabatic bulk modulus; kappa_S = 1/K_S
///     w       = (K_S/rho)^(1/2)                speed of sound
///     mu_JT   = (T alpha_p - 1)/(rho c_p)      Joule-Thomson coefficient      (dT/dp)_H
///
/// Errors are for the whole formula as a function of all means, with their correlations: the larger one of the error by
/// block averages (BlockingAccumulator, to first order) and of a jackknife over 32 to 64 blocks (JackknifeBlocks). To
/// it is added what the value would change if all variances were too low by 1/n, n being the independent samples of the
/// fluctuating quantities; c_v at constant pressure is the fluctuation of the energy at fixed volume, of dU - dV <dU
/// dV>/<dV^2>, which is faster than the volume. There is no value where the run is too short for these errors; where
/// K_T or c_v is not known to a quarter of itself, what is divided by it has none either.
class ResponseFunctions {
  public:
    /// @param ensemble        of all samples
    /// @param held_pressure   in the isothermal-isobaric ensemble
    /// @param with_stiffness  whether samples have one; without, K_T has a value in the isothermal-isobaric ensemble
    /// only
    ResponseFunctions(Index atoms, Ensemble ensemble, std::optional<double> held_pressure, bool with_stiffness);

    void add(const ResponseSample& sample);
    [[nodiscard]] Index samples() const { return series_.samples(); }

    /// isothermal_compressibility, thermal_expansion, thermal_pressure_coefficient, heat_capacity_cp,
    /// adiabatic_compressibility, speed_of_sound, joule_thomson_coefficient; heat_capacity_cv in the
    /// isothermal-isobaric ensemble, where RunAverages has none. Empty without samples. What has no value has a remark.
    [[nodiscard]] std::vector<ObservableAverage> observables() const;

    void archive(Archive& a) { a(first_volume_, first_energy_, first_pressure_, series_, blocks_); }

    /// Memory of this many samples, also in a checkpoint [bytes].
    [[nodiscard]] static double bytes(Index samples) {
        return BlockingAccumulator::bytes(response::columns, Covariance::full, samples) +
               JackknifeBlocks::bytes(response::columns);
    }

  private:
    /// All values that follow from these means, and the bulk modulus.
    [[nodiscard]] Eigen::VectorXd values_at(const Eigen::VectorXd& means) const;
    [[nodiscard]] std::vector<Estimate> estimates() const;
    /// Independent samples of dU - dV <dU dV>/<dV^2>.
    [[nodiscard]] double energies_at_fixed_volume() const;

    double atoms_;
    Ensemble ensemble_;
    double held_pressure_;
    bool with_stiffness_;
    double first_volume_ = 0.0;
    double first_energy_ = 0.0;
    double first_pressure_ = 0.0;
    BlockingAccumulator series_;
    JackknifeBlocks blocks_;
};

/// Take the values of response functions away where the density is a guess: its fluctuation is known less well.
void withhold_slow_responses(std::vector<ObservableAverage>& averages);

}  // namespace ljmd
