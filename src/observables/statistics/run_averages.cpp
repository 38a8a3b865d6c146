#include "ljmd/detail/observables/statistics/run_averages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ljmd/detail/observables/statistics/known_quantity.hpp"
#include "model/velocities.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

namespace {

constexpr Index temperature_column = 0;
constexpr Index potential_energy_column = 1;
constexpr Index kinetic_energy_column = 2;
constexpr Index total_energy_column = 3;
constexpr Index pressure_column = 4;
constexpr Index density_column = 5;
constexpr Index first_shear_column = 9;  // p_xy, p_xz and p_yz
constexpr Index virial_column = 12;

/// After the reported columns: 1/T, u^2 and, where there is one, the external energy.
constexpr auto inverse_temperature_column = static_cast<Index>(sampled_quantities.size());
constexpr Index squared_energy_column = inverse_temperature_column + 1;
constexpr Index external_energy_column = squared_energy_column + 1;

/// As many encounters as independent samples are asked for elsewhere: the error is then known to 18 %.
constexpr Index enough_encounters = 16;

/// In units of the potential energy's error: the total energy's error is larger where a bath exchanges energy slowly,
/// since the kinetic energy follows. Where the integrator alone changes it, and where the potential energy alone is
/// slow, it is not.
constexpr double noticeable_exchange = 1.5;

/// Of the error of the shear stress when blocks are made four times as long: 2 where they are shorter than its
/// correlations.
constexpr double growth_of_slow_stress = 1.6;

/// Independent samples of energy and volume: a tenth of the runs that are a few of their correlation times long looks
/// as if it had 16.
constexpr double enough_exchanges = 24.0;

/// Of the volume, by the time in which it relaxes, which follows from its variance: short runs find too small a one,
/// and of those that hold 15 some look as if they held 28.
constexpr double enough_volumes = 32.0;

/// Independent samples of what a heat capacity is the fluctuation of. Of runs with fewer those that look long enough
/// are those that missed its slow part: near 30 in a gas their heat capacities were low by 2 errors.
constexpr double enough_fluctuations = 64.0;

/// Of an energy that is conserved but for errors of the integrator. @pre at least two samples
Estimate conserved(const BlockingAccumulator& series, Index column) {
    const double deviation =
        series.levels(column).front().standard_error * std::sqrt(static_cast<double>(series.samples()));
    return {series.mean()[column], deviation, std::numeric_limits<double>::quiet_NaN(), series.samples(), true};
}

constexpr const char* never_met =
    "no two atoms were within the cutoff in any sample: the run is too short for so dilute a gas";

}  // namespace

RunAverages::RunAverages(Index atoms, Ensemble ensemble, bool external_energy, const Baths& baths)
    : atoms_(static_cast<double>(atoms)),
      degrees_of_freedom_(static_cast<double>(degrees_of_freedom(atoms))),
      ensemble_(ensemble),
      external_energy_(external_energy),
      baths_(baths),
      series_(external_energy_column + (external_energy ? 1 : 0), Covariance::full),
      blocks_(series_.width()) {}

void RunAverages::add(const Thermodynamics& s) {
    const Mat3 p = s.pressure_tensor.value_or(Mat3::Zero());
    const double t = s.temperature.value_or(0.0);
    Eigen::VectorXd row(series_.width());
    if (external_energy_) {
        row[external_energy_column] = s.external_energy.value_or(0.0);
    }
    row.head(external_energy_column) << t, s.potential_energy, s.kinetic_energy, s.total_energy,
        s.pressure.value_or(0.0), s.density, p(0, 0), p(1, 1), p(2, 2), p(0, 1), p(0, 2), p(1, 2), s.virial,
        t > 0.0 ? 1.0 / t : 0.0, s.potential_energy * s.potential_energy;
    series_.add(row);
    blocks_.add(row);
    const bool meet = s.virial != 0.0;
    apart_ += meet ? 0 : 1;
    encounters_ += meet && !met_before_ ? 1 : 0;
    met_before_ = meet;
}

bool RunAverages::met_rarely() const {
    return degrees_of_freedom_ > 0.0 && apart_ > 0 && encounters_ < enough_encounters;
}

bool RunAverages::knows_collisions() const {
    if (2 * apart_ > samples()) {
        return true;  // its encounters are counted, see met_rarely()
    }
    // Of the three together, whose scatter hides less than one's does.
    std::vector<double> errors;
    for (Index column = first_shear_column; column < virial_column; ++column) {
        const std::vector<BlockLevel> levels = series_.levels(column);
        const auto many = std::ranges::count_if(levels, [](const BlockLevel& each) { return each.blocks >= 16; });
        errors.resize(static_cast<std::size_t>(many));
        for (std::size_t k = 0; k < errors.size(); ++k) {
            errors[k] = std::hypot(errors[k], levels[k].standard_error);
        }
    }
    return errors.size() < 3 || !(errors.back() > growth_of_slow_stress * errors[errors.size() - 3]);
}

Vec3 RunAverages::means_of_state() const {
    const Eigen::VectorXd mean = series_.mean();
    return {mean[temperature_column], mean[potential_energy_column], mean[pressure_column]};
}

Estimate RunAverages::estimate(double value, const Vec3& gradient) const {
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(series_.width());
    whole[temperature_column] = gradient[0];
    whole[potential_energy_column] = gradient[1];
    whole[pressure_column] = gradient[2];
    return estimate_of(value, whole);
}

Estimate RunAverages::with_exchange(Estimate found, const Eigen::VectorXd& gradient) const {
    const auto limit = [&](Index column, double most, double enough) {
        const Eigen::VectorXd with_column = series_.covariances(column);
        found.converged = found.converged && most >= enough;
        const double least = std::abs(gradient.dot(with_column)) / std::sqrt(with_column[column] * std::max(most, 1.0));
        if (least > found.standard_error) {
            const double part = found.standard_error / least;
            found.independent_samples *= part * part;
            found.standard_error = least;
        }
    };
    const auto half = 0.5 * static_cast<double>(samples());
    const double kinetic = series_.covariances(kinetic_energy_column)[kinetic_energy_column];
    const double total = series_.covariances(total_energy_column)[total_energy_column];
    if (baths_.exchange > 0.0 && kinetic > 0.0 && total > 0.0) {
        limit(total_energy_column, half * kinetic / (baths_.exchange * total), enough_exchanges);
    }
    const Eigen::VectorXd mean = series_.mean();
    const double density = mean[density_column];
    const double compressibility = atoms_ * series_.covariances(density_column)[density_column] /
                                   (density * density * density * mean[temperature_column]);
    if (baths_.volume_mobility > 0.0 && compressibility > 0.0) {
        limit(density_column, half * baths_.volume_mobility / compressibility, enough_volumes);
    }
    return found;
}

Estimate RunAverages::estimate_of(double value, const Eigen::VectorXd& gradient) const {
    std::vector<Index> exchanged;
    if (series_.estimate(total_energy_column).standard_error >
        noticeable_exchange * series_.estimate(potential_energy_column).standard_error) {
        exchanged.push_back(total_energy_column);
    }
    if (volume_fluctuates(ensemble_)) {
        exchanged.push_back(density_column);
    }
    const bool of_motion = gradient[temperature_column] + gradient[kinetic_energy_column] == gradient.sum();
    // A reflection changes the sign of shear stress and of no energy or volume: it has no part of what is slow in them.
    const bool of_shear = !external_energy_ && gradient.segment(first_shear_column, 3).sum() == gradient.sum();
    std::vector<Index> slow;
    if (!of_shear) {
        slow = exchanged;
        if (!of_motion) {
            slow.push_back(potential_energy_column);
        }
    }
    Estimate found = series_.estimate(value, gradient, slow);
    const bool is_short = std::ranges::any_of(
        exchanged, [this](Index column) { return series_.estimate(column).independent_samples < enough_exchanges; });
    found.converged = found.converged && !is_short && (of_motion || knows_collisions());
    return with_exchange(found, gradient);
}

std::optional<Estimate> RunAverages::compressibility_factor() const {
    const Eigen::VectorXd mean = series_.mean();
    const double t = mean[temperature_column];
    const double p = mean[pressure_column];
    const double density = mean[density_column];
    if (!is_above_zero(t)) {
        return std::nullopt;
    }
    const double z = p / (density * t);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(series_.width());
    gradient[pressure_column] = 1.0 / (density * t);
    gradient[density_column] = -z / density;
    gradient[temperature_column] = -z / t;
    return estimate_of(z, gradient);
}

std::optional<ObservableAverage> RunAverages::heat_capacity() const {
    const bool at_constant_energy = ensemble_ == Ensemble::constant_energy;
    if (!at_constant_energy && ensemble_ != Ensemble::canonical) {
        return std::nullopt;
    }
    ObservableAverage c = average_of("heat_capacity_cv");
    if (!is_above_zero(series_.mean()[temperature_column])) {
        c.remark = no_temperature;
        return c;
    }
    c.estimate = at_constant_energy ? heat_capacity_at_constant_energy() : heat_capacity_at_constant_temperature();
    if (!c.estimate) {
        c.remark = "the temperature fluctuates more than any heat capacity allows: the run is too short";
        return c;
    }
    const Estimate fluctuating = series_.estimate(at_constant_energy ? temperature_column : potential_energy_column);
    if (!c.estimate->converged || !fluctuating.converged || fluctuating.independent_samples < enough_fluctuations) {
        c.estimate.reset();
        c.remark = fmt::format("the run is too short to tell how its {} fluctuates",
                               at_constant_energy ? "temperature" : "energy");
        return c;
    }
    const double by_jackknife = blocks_.errors([this](const Eigen::VectorXd& means) {
        return Eigen::VectorXd(Eigen::VectorXd::Constant(1, heat_capacity_of(means)));
    })[0];
    c.estimate->standard_error = std::hypot(std::fmax(c.estimate->standard_error, by_jackknife),
                                            heat_capacity_missed(c.estimate->mean) / fluctuating.independent_samples);
    return c;
}

double RunAverages::heat_capacity_missed(double c) const {
    if (ensemble_ == Ensemble::canonical) {
        return c - 1.5;
    }
    const double of_motion = c - 1.5 / atoms_;
    return of_motion * std::abs(2.0 * atoms_ * of_motion / degrees_of_freedom_ - 1.0);
}

double RunAverages::heat_capacity_of(const Eigen::VectorXd& means) const {
    const double t = means[temperature_column];
    if (ensemble_ == Ensemble::canonical) {
        const double u = means[potential_energy_column];
        return atoms_ / (t * t) * (means[squared_energy_column] - u * u) + 1.5;
    }
    const double share = 1.0 - 2.0 / degrees_of_freedom_;
    return 1.0 / (atoms_ * (1.0 - share * t * means[inverse_temperature_column])) + 1.5 / atoms_;
}

std::optional<Estimate> RunAverages::heat_capacity_at_constant_energy() const {
    const Eigen::VectorXd mean = series_.mean();
    const double t = mean[temperature_column];
    const double inverse = mean[inverse_temperature_column];
    const double share = 1.0 - 2.0 / degrees_of_freedom_;
    const double rest = 1.0 - share * t * inverse;
    if (!(rest > 0.0)) {
        return std::nullopt;  // larger fluctuations than any heat capacity allows
    }
    const double c = heat_capacity_of(mean);
    const double slope = (c - 1.5 / atoms_) * share / rest;  // dc/d(<T> <1/T>)
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(series_.width());
    gradient[temperature_column] = slope * inverse;
    gradient[inverse_temperature_column] = slope * t;
    return estimate_of(c, gradient);
}

std::optional<Estimate> RunAverages::heat_capacity_at_constant_temperature() const {
    const Eigen::VectorXd mean = series_.mean();
    const double t = mean[temperature_column];
    const double u = mean[potential_energy_column];
    const double per_variance = atoms_ / (t * t);
    const double c = heat_capacity_of(mean);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(series_.width());
    gradient[squared_energy_column] = per_variance;
    gradient[potential_energy_column] = -2.0 * per_variance * u;
    gradient[temperature_column] = -2.0 * (c - 1.5) / t;
    return estimate_of(c, gradient);
}

std::vector<ObservableAverage> RunAverages::averages() const {
    std::vector<ObservableAverage> result;
    if (samples() == 0) {
        return result;
    }
    for (Index k = 0; k < static_cast<Index>(sampled_quantities.size()); ++k) {
        const KnownQuantity& column = sampled_quantities[static_cast<std::size_t>(k)];
        if (k == density_column && !volume_fluctuates(ensemble_)) {
            continue;
        }
        const bool is_pressure = k == pressure_column || (k > density_column && k < virial_column);
        ObservableAverage average{column.name, column.symbol, column.unit, std::nullopt};
        if (degrees_of_freedom_ == 0.0 && (k == temperature_column || is_pressure)) {
            average.remark = "a single atom has no motion about the centre of mass: no temperature and no pressure";
        } else {
            average.estimate = estimate_of(series_.mean()[k], Eigen::VectorXd::Unit(series_.width(), k));
            if (k == total_energy_column && ensemble_ == Ensemble::constant_energy && samples() > 1) {
                average.estimate = conserved(series_, k);
            }
        }
        result.push_back(average);
        if (met_rarely() && (k == potential_energy_column || k == virial_column)) {
            result.back().estimate->converged = false;
        }
        if (k == total_energy_column && external_energy_) {
            result.push_back({"external_energy", "U_ext/N", "epsilon", series_.estimate(external_energy_column)});
        }
        if (k == pressure_column) {
            ObservableAverage z = average_of("compressibility_factor", compressibility_factor());
            if (!z.estimate) {
                z.remark = no_temperature;
            } else if (met_rarely() && encounters_ == 0) {
                z.estimate.reset();
                z.remark = never_met;
            } else if (met_rarely()) {
                z.estimate->converged = false;
            }
            result.push_back(z);
            if (const auto c = heat_capacity()) {
                result.push_back(*c);
            }
        }
    }
    return result;
}

}  // namespace ljmd
