#include "observables/transport/stress_autocorrelation.hpp"

#include <limits>
#include <numbers>

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/velocities.hpp"
#include "observables/statistics/known_quantities.hpp"

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
    : volume_(box.volume()), every_(lags.every), series_(6, lags, window, 10.0) {}

void StressAutocorrelation::sample(const State& state, const Evaluation& evaluation) {
    ++samples_;
    series_.add(shear_part(mechanical_stress(state, evaluation)), temperature(state).value_or(0.0), state.execution());
}

double StressAutocorrelation::viscosity_per_integral() const {
    const double temperature = series_.averages().temperature();
    return is_above_zero(temperature) ? volume_ / temperature : std::numeric_limits<double>::quiet_NaN();
}

std::vector<DataTable> StressAutocorrelation::tables() const {
    if (series_.averages().windows() == 0) {
        return {};
    }
    return {series_.averages().table("stress_autocorrelation", "viscosity", viscosity_per_integral())};
}

std::vector<ObservableAverage> StressAutocorrelation::observables() const {
    if (series_.averages().windows() == 0) {
        return {};
    }
    return {series_.averages().coefficient(average_of("viscosity"), viscosity_per_integral())};
}

}  // namespace ljmd
