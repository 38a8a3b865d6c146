#include "ljmd/observables/transport/stress_autocorrelation.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "ljmd/model/velocities.hpp"
#include "ljmd/observables/thermodynamics.hpp"
#include "ljmd/observables/transport/green_kubo.hpp"

namespace ljmd {

namespace {

/// The traceless symmetric part of a tensor as six numbers with the same sum of squares as its nine.
Eigen::VectorXd shear_part(const Mat3& p) {
    const double mean = p.trace() / 3.0;
    const double root = 0.5 * std::numbers::sqrt2;
    Eigen::VectorXd part(6);
    part << p(0, 0) - mean, p(1, 1) - mean, p(2, 2) - mean, root * (p(0, 1) + p(1, 0)), root * (p(0, 2) + p(2, 0)),
        root * (p(1, 2) + p(2, 1));
    return part;
}

}  // namespace

StressAutocorrelation::StressAutocorrelation(const Box& box, const LagTimes& lags, Index window)
    : volume_(box.volume()),
      lags_(lags),
      every_(lags.every),
      window_(6, lags.count, window),
      means_(2 * (lags.count + 1) + 2, Covariance::diagonal) {}

void StressAutocorrelation::sample(const State& state, const Evaluation& evaluation) {
    ++samples_;
    ++in_window_;
    temperature_sum_ += temperature(state).value_or(0.0);
    const std::optional<Eigen::VectorXd> sum =
        window_.add(shear_part(mechanical_stress(state, evaluation)), state.execution());
    if (!sum) {
        return;
    }
    const Index times = lags_.count + 1;
    Eigen::VectorXd found(means_.width());
    found.head(times) = *sum / 10.0;
    found.segment(times, times) = running_integral(found.head(times), lags_.spacing);
    found[2 * times] = temperature_sum_ / static_cast<double>(in_window_);
    found[2 * times + 1] = change_at_double_spacing(found.head(times), lags_.spacing);
    means_.add(found);
    in_window_ = 0;
    temperature_sum_ = 0.0;
}

void StressAutocorrelation::interrupt() {
    window_.interrupt();
    in_window_ = 0;
    temperature_sum_ = 0.0;
}

double StressAutocorrelation::viscosity_per_integral() const {
    const double temperature = means_.mean()[2 * (lags_.count + 1)];
    return is_above_zero(temperature) ? volume_ / temperature : std::numeric_limits<double>::quiet_NaN();
}

Estimate StressAutocorrelation::viscosity() const {
    Estimate viscosity = means_.estimate(2 * lags_.count + 1);
    viscosity.mean *= viscosity_per_integral();
    viscosity.standard_error *= viscosity_per_integral();
    return viscosity;
}

double StressAutocorrelation::change_of_viscosity() const {
    return viscosity_per_integral() * means_.mean()[means_.width() - 1];
}

std::vector<DataTable> StressAutocorrelation::tables() const {
    if (means_.samples() == 0) {
        return {};
    }
    DataTable table{"stress_autocorrelation",
                    {"time", "stress_autocorrelation", "stress_autocorrelation_standard_error", "viscosity",
                     "viscosity_standard_error"},
                    {}};
    const Index times = lags_.count + 1;
    const bool has_integrals = frames_are_close(viscosity(), change_of_viscosity());
    const double factor = has_integrals ? viscosity_per_integral() : std::numeric_limits<double>::quiet_NaN();
    for (Index k = 0; k < times; ++k) {
        const Estimate c = means_.estimate(k);
        const Estimate integral = means_.estimate(times + k);
        table.rows.push_back(
            {lags_.time(k), c.mean, c.standard_error, factor * integral.mean, factor * integral.standard_error});
    }
    return {table};
}

std::vector<ObservableAverage> StressAutocorrelation::observables() const {
    if (means_.samples() == 0) {
        return {};
    }
    if (std::isnan(viscosity_per_integral())) {
        return {{"viscosity", "eta", "epsilon tau/sigma^3", std::nullopt, no_temperature}};
    }
    return {green_kubo_integral({"viscosity", "eta", "epsilon tau/sigma^3", viscosity()}, change_of_viscosity())};
}

}  // namespace ljmd
