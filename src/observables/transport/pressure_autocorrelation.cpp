#include "observables/transport/pressure_autocorrelation.hpp"

#include <limits>
#include <numeric>

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "model/velocities.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

PressureAutocorrelation::PressureAutocorrelation(const Box& box, const LagTimes& lags, Index window)
    : volume_(box.volume()), lags_(lags), window_(window), every_(lags.every), stages_(1) {}

void PressureAutocorrelation::sample(const State& state, const Evaluation& evaluation) {
    ++samples_;
    temperature_sum_ += temperature(state).value_or(0.0);
    stages_.back().push_back(mechanical_stress(state, evaluation).trace() / 3.0);
}

void PressureAutocorrelation::interrupt() {
    if (!stages_.back().empty()) {
        stages_.emplace_back();
    }
}

double PressureAutocorrelation::viscosity_per_integral() const {
    const double temperature = temperature_sum_ / static_cast<double>(samples_);
    return is_above_zero(temperature) ? volume_ / temperature : std::numeric_limits<double>::quiet_NaN();
}

void PressureAutocorrelation::add_windows(const std::vector<double>& pressures, GreenKuboAverages& averages) const {
    const auto frames = static_cast<Index>(pressures.size());
    const double mean = std::accumulate(pressures.begin(), pressures.end(), 0.0) / static_cast<double>(frames);
    const double stage_time = lags_.time(frames);
    const double variance_per_integral = 2.0 / stage_time / (1.0 - 2.0 * lags_.time(lags_.count) / stage_time);
    CorrelationWindows windows(1, lags_.count, window_);
    const Execution one_thread;
    for (const double pressure : pressures) {
        if (auto c = windows.add(Eigen::VectorXd::Constant(1, pressure - mean), one_thread)) {
            const double integral = running_integral(*c, lags_.spacing)[lags_.count];
            averages.add((c->array() + variance_per_integral * integral).matrix(),
                         temperature_sum_ / static_cast<double>(samples_));
        }
    }
}

GreenKuboAverages PressureAutocorrelation::averages() const {
    GreenKuboAverages averages(lags_);
    for (const std::vector<double>& pressures : stages_) {
        if (static_cast<Index>(pressures.size()) >= shortest_stage * lags_.count) {
            add_windows(pressures, averages);
        }
    }
    return averages;
}

std::vector<DataTable> PressureAutocorrelation::tables() const {
    const GreenKuboAverages found = averages();
    if (found.windows() == 0) {
        return {};
    }
    return {found.table("pressure_autocorrelation", "bulk_viscosity", viscosity_per_integral())};
}

std::vector<ObservableAverage> PressureAutocorrelation::observables() const {
    const GreenKuboAverages found = averages();
    if (found.windows() == 0) {
        return {};
    }
    ObservableAverage viscosity = found.coefficient(average_of("bulk_viscosity"), viscosity_per_integral());
    if (viscosity.estimate && !found.has_levelled_out()) {
        viscosity.estimate.reset();
        viscosity.remark = still_changes;
    }
    return {viscosity};
}

}  // namespace ljmd
