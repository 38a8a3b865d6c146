#include "observables/response/response_functions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unsupported/Eigen/AutoDiff>

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "observables/response/canonical.hpp"
#include "observables/response/constant_energy.hpp"
#include "observables/response/isothermal_isobaric.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

namespace {

/// A number with its derivatives with respect to all means and to the share of the variances.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, response::columns + 1, 1>>;

/// Values that are divided by something are wanted only if that is known to this many errors.
constexpr double errors_above_zero = 4.0;

constexpr const char* too_short = "the run is too short to tell how its energy, pressure and volume fluctuate";

/// A response function as results.json has it.
struct Named {
    const char* name;
    bool by_bulk_modulus;   ///< divided by it, or by what contains it
    bool by_heat_capacity;  ///< divided by c_v
};

constexpr std::size_t c_v_place = 3;
constexpr std::array<Named, 8> named{{{"isothermal_compressibility", true, false},
                                      {"thermal_expansion", true, false},
                                      {"thermal_pressure_coefficient", false, false},
                                      {"heat_capacity_cv", false, false},
                                      {"heat_capacity_cp", true, false},
                                      {"adiabatic_compressibility", true, true},
                                      {"speed_of_sound", true, true},
                                      {"joule_thomson_coefficient", true, true}}};

/// The values of all that is named, and last the isothermal bulk modulus.
constexpr std::size_t modulus_place = named.size();
template <class Real>
using Values = std::array<Real, named.size() + 1>;

template <class Real>
Values<Real> values_of(const response::Means<Real>& means, Ensemble ensemble) {
    using std::sqrt;
    const response::Basis<Real> basis = ensemble == Ensemble::isothermal_isobaric ? response::isothermal_isobaric(means)
                                        : ensemble == Ensemble::constant_energy   ? response::constant_energy(means)
                                                                                  : response::canonical(means);
    const Real t = means.mean[response::temperature];
    const Real rho = means.density();
    const Real c_v = basis.heat_capacity;
    const Real slope = basis.pressure_slope;
    const Real modulus = basis.bulk_modulus;
    const Real alpha = slope / modulus;
    const Real c_p = c_v + t * slope * slope / (rho * modulus);
    const Real adiabatic = modulus + t * slope * slope / (rho * c_v);
    return {Real(1.0 / modulus),
            alpha,
            slope,
            c_v,
            c_p,
            Real(1.0 / adiabatic),
            Real(sqrt(Real(adiabatic / rho))),
            Real((t * alpha - 1.0) / (rho * c_p)),
            modulus};
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
      series_(response::columns, Covariance::full),
      blocks_(response::columns) {}

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
    blocks_.add(row);
}

Eigen::VectorXd ResponseFunctions::values_at(const Eigen::VectorXd& means) const {
    const Values<double> values = values_of(
        response::Means<double>{means, 1.0, first_pressure_, first_volume_, atoms_, held_pressure_}, ensemble_);
    return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Index>(values.size()));
}

double ResponseFunctions::energies_at_fixed_volume() const {
    const Eigen::VectorXd with_volume = series_.covariances(response::volume);
    Eigen::VectorXd gradient = Eigen::VectorXd::Unit(series_.width(), response::energy);
    gradient[response::volume] = -with_volume[response::energy] / with_volume[response::volume];
    return series_.estimate(0.0, gradient).independent_samples;
}

std::vector<Estimate> ResponseFunctions::estimates() const {
    constexpr int all = response::columns + 1;
    const Eigen::VectorXd mean = series_.mean();
    response::Means<Dual> means{
        {}, Dual(1.0, all, response::columns), first_pressure_, first_volume_, atoms_, held_pressure_};
    for (int k = 0; k < response::columns; ++k) {
        means.mean[k] = Dual(mean[k], all, k);
    }
    double slowest = static_cast<double>(samples());
    bool long_enough = true;
    for (const response::Column column : fluctuating(ensemble_)) {
        const Estimate of_column = series_.estimate(column);
        slowest = std::min(slowest, of_column.independent_samples);
        long_enough = long_enough && of_column.converged;
    }
    const Eigen::VectorXd jackknife = blocks_.errors([this](const Eigen::VectorXd& at) { return values_at(at); });
    std::vector<Estimate> found;
    found.reserve(named.size() + 1);
    for (const Dual& value : values_of(means, ensemble_)) {
        Estimate each = series_.estimate(value.value(), value.derivatives().head(response::columns));
        const double by_blocks = jackknife[static_cast<Index>(found.size())];
        const bool at_fixed_volume = ensemble_ == Ensemble::isothermal_isobaric && found.size() == c_v_place;
        const double independent = at_fixed_volume ? energies_at_fixed_volume() : slowest;
        each.converged = each.converged && long_enough && std::isfinite(by_blocks);
        each.standard_error =
            std::hypot(std::max(each.standard_error, by_blocks), value.derivatives()[response::columns] / independent);
        found.push_back(each);
    }
    return found;
}

std::vector<ObservableAverage> ResponseFunctions::observables() const {
    if (samples() == 0) {
        return {};
    }
    const std::vector<Estimate> found = estimates();
    const auto is_known = [&](std::size_t place) {
        return found[place].converged && found[place].mean > errors_above_zero * found[place].standard_error;
    };
    const bool isobaric = ensemble_ == Ensemble::isothermal_isobaric;
    const bool fluctuates = isobaric || ensemble_ == Ensemble::canonical || ensemble_ == Ensemble::constant_energy;
    const bool is_warm = is_above_zero(series_.mean()[response::temperature]) && atoms_ > 1.0;
    const auto remark_on = [&](std::size_t place) -> std::string {
        const Named& each = named.at(place);
        if (!fluctuates) {
            return "fluctuations determine it in one sampled stage: at constant energy, or under a canonical "
                   "thermostat with or without a barostat";
        }
        if (!is_warm) {
            return no_temperature;
        }
        if (each.by_bulk_modulus && !isobaric && !with_stiffness_) {
            return "it needs the hypervirial: ask for the analysis response_functions";
        }
        const bool unknown = !found[place].converged || (each.by_bulk_modulus && !is_known(modulus_place)) ||
                             (each.by_heat_capacity && !is_known(c_v_place));
        return unknown ? too_short : "";
    };
    std::vector<ObservableAverage> result;
    result.reserve(named.size());
    for (std::size_t place = 0; place < named.size(); ++place) {
        if (place == c_v_place && !isobaric) {
            continue;  // RunAverages has it, from more samples
        }
        const Named& each = named.at(place);
        ObservableAverage average = average_of(each.name, std::nullopt, remark_on(place));
        if (average.remark.empty()) {
            average.estimate = found[place];
        }
        result.push_back(average);
    }
    return result;
}

void withhold_slow_responses(std::vector<ObservableAverage>& averages) {
    const auto density = std::ranges::find(averages, "density", &ObservableAverage::name);
    if (density == averages.end() || !density->estimate || density->estimate->converged) {
        return;
    }
    for (ObservableAverage& average : averages) {
        if (average.estimate && std::ranges::find(named, average.name, &Named::name) != named.end()) {
            average.estimate.reset();
            average.remark = too_short;
        }
    }
}

}  // namespace ljmd
