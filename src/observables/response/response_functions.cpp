#include "ljmd/observables/response/response_functions.hpp"

#include <algorithm>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "ljmd/observables/response/canonical.hpp"
#include "ljmd/observables/response/constant_energy.hpp"
#include "ljmd/observables/response/isothermal_isobaric.hpp"
#include "ljmd/observables/thermodynamics.hpp"

namespace ljmd {

namespace {

/// A number with its derivatives with respect to all means and to the share of the variances.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, response::columns + 1, 1>>;

/// Values that are divided by something are wanted only if that is known to this many errors.
constexpr double errors_above_zero = 4.0;

constexpr const char* too_short = "the run is too short to tell how its energy, pressure and volume fluctuate";

/// One response function.
struct Named {
    const char* name;
    const char* symbol;
    const char* unit;
    Dual value;
    bool by_bulk_modulus;   ///< divided by it, or by what contains it
    bool by_heat_capacity;  ///< divided by c_v
};

std::vector<Named> all_of(const response::Basis<Dual>& basis, const Dual& temperature, const Dual& rho) {
    using std::sqrt;
    const Dual c_v = basis.heat_capacity;
    const Dual slope = basis.pressure_slope;
    const Dual modulus = basis.bulk_modulus;
    const Dual alpha = slope / modulus;
    const Dual c_p = c_v + temperature * slope * slope / (rho * modulus);
    const Dual adiabatic = modulus + temperature * slope * slope / (rho * c_v);
    const Dual sound = sqrt(Dual(adiabatic / rho));
    return {{"isothermal_compressibility", "kappa_T", "sigma^3/epsilon", Dual(1.0 / modulus), true, false},
            {"thermal_expansion", "alpha_p", "k_B/epsilon", alpha, true, false},
            {"thermal_pressure_coefficient", "gamma_V", "k_B/sigma^3", slope, false, false},
            {"heat_capacity_cv", "c_v", "k_B", c_v, false, false},
            {"heat_capacity_cp", "c_p", "k_B", c_p, true, false},
            {"adiabatic_compressibility", "kappa_S", "sigma^3/epsilon", Dual(1.0 / adiabatic), true, true},
            {"speed_of_sound", "w", "sigma/tau", sound, true, true},
            {"joule_thomson_coefficient", "mu_JT", "sigma^3/k_B", Dual((temperature * alpha - 1.0) / (rho * c_p)), true,
             true}};
}

/// The quantities whose fluctuations the formulas of an ensemble use.
std::vector<response::Column> fluctuating(Ensemble ensemble) {
    switch (ensemble) {
        case Ensemble::canonical:
            return {response::energy, response::pressure};
        case Ensemble::constant_energy:
            return {response::temperature, response::pressure};
        default:
            return {response::energy, response::volume};
    }
}

}  // namespace

ResponseFunctions::ResponseFunctions(Index atoms, Ensemble ensemble, std::optional<double> held_pressure,
                                     bool with_stiffness)
    : atoms_(static_cast<double>(atoms)),
      ensemble_(ensemble),
      held_pressure_(held_pressure.value_or(0.0)),
      with_stiffness_(with_stiffness),
      series_(response::columns, Covariance::full) {}

void ResponseFunctions::add(const ResponseSample& sample) {
    if (samples() == 0) {
        first_volume_ = sample.volume;
        first_energy_ = sample.energy;
        first_pressure_ = sample.pressure;
    }
    const double t = sample.temperature;
    const double inverse = is_above_zero(t) ? 1.0 / t : 0.0;
    const double u = sample.energy - first_energy_;
    const double p = sample.pressure - first_pressure_;
    const double v = sample.volume - first_volume_;
    Eigen::VectorXd row(Index{response::columns});
    row << t, inverse, u, p, v, (with_stiffness_ ? sample.stiffness : 0.0), u * u, u * p, p * p, v * v, u * v,
        p * inverse, p * p * inverse;
    series_.add(row);
}

std::vector<ObservableAverage> ResponseFunctions::observables() const {
    if (samples() == 0) {
        return {};
    }
    const Eigen::VectorXd mean = series_.mean();
    constexpr int all = response::columns + 1;
    response::Means<Dual> means{
        {}, Dual(1.0, all, response::columns), first_pressure_, first_volume_, atoms_, held_pressure_};
    for (int k = 0; k < response::columns; ++k) {
        means.mean[k] = Dual(mean[k], all, k);
    }
    const bool isobaric = ensemble_ == Ensemble::isothermal_isobaric;
    const bool known = isobaric || ensemble_ == Ensemble::canonical || ensemble_ == Ensemble::constant_energy;
    const response::Basis<Dual> basis = isobaric                                 ? response::isothermal_isobaric(means)
                                        : ensemble_ == Ensemble::constant_energy ? response::constant_energy(means)
                                                                                 : response::canonical(means);
    double independent = static_cast<double>(samples());
    bool long_enough = true;
    for (const response::Column column : fluctuating(ensemble_)) {
        const Estimate of_column = series_.estimate(column);
        independent = std::min(independent, of_column.independent_samples);
        long_enough = long_enough && of_column.converged;
    }
    const auto estimate_of = [&](const Dual& value) {
        Estimate found = series_.estimate(value.value(), value.derivatives().head(response::columns));
        found.standard_error = std::hypot(found.standard_error, value.derivatives()[response::columns] / independent);
        found.converged = found.converged && long_enough && std::isfinite(found.standard_error);
        return found;
    };
    const auto is_positive = [&](const Dual& value) {
        const Estimate found = estimate_of(value);
        return found.converged && found.mean > errors_above_zero * found.standard_error;
    };
    const bool sound_temperature = is_above_zero(mean[response::temperature]) && atoms_ > 1.0;
    const bool has_modulus = with_stiffness_ || isobaric;
    // A compressibility from the fluctuations of the volume is as well known as its inverse.
    const bool modulus_is_known = has_modulus && sound_temperature && is_positive(basis.bulk_modulus);
    const bool capacity_is_known = sound_temperature && is_positive(basis.heat_capacity);
    std::vector<ObservableAverage> result;
    result.reserve(8);
    for (const Named& each : all_of(basis, means.mean[response::temperature], means.density())) {
        ObservableAverage average{each.name, each.symbol, each.unit, std::nullopt};
        if (average.name == "heat_capacity_cv" && !isobaric) {
            continue;  // RunAverages has it, from more samples
        }
        if (!known) {
            average.remark =
                "fluctuations determine it in one sampled stage: at constant energy, or under a canonical thermostat "
                "with or without a barostat";
        } else if (!sound_temperature) {
            average.remark = no_temperature;
        } else if (each.by_bulk_modulus && !has_modulus) {
            average.remark = "it needs the hypervirial: ask for the analysis response_functions";
        } else if ((each.by_bulk_modulus && !modulus_is_known) || (each.by_heat_capacity && !capacity_is_known)) {
            average.remark = too_short;
        } else if (const Estimate found = estimate_of(each.value); found.converged) {
            average.estimate = found;
        } else {
            average.remark = too_short;
        }
        result.push_back(average);
    }
    return result;
}

}  // namespace ljmd
