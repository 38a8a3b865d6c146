#include "observables/transport/velocity_autocorrelation.hpp"

#include <limits>
#include <numbers>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "observables/transport/centre_frame.hpp"
#include "observables/transport/green_kubo.hpp"
#include "observables/transport/long_times.hpp"

namespace ljmd {

namespace {

const VelocityAutocorrelation::Level& first_of(const std::vector<VelocityAutocorrelation::Level>& levels) {
    if (levels.empty()) {
        throw ContractViolation("velocity autocorrelation at no times");
    }
    return levels.front();
}

}  // namespace

VelocityAutocorrelation::VelocityAutocorrelation(Index atoms, const std::vector<Level>& levels)
    : atoms_(atoms),
      lags_(first_of(levels).lags),
      every_(lags_.every),
      cosines_(lags_.count + 1),
      window_(3 * atoms, lags_.count, levels.front().window),
      means_(3 * (lags_.count + 1) + 1, Covariance::diagonal) {
    for (std::size_t n = 1; n < levels.size(); ++n) {
        const Level& level = levels[n];
        coarse_.push_back({level.lags, CorrelationWindows(3 * atoms, level.lags.count, level.window),
                           BlockingAccumulator(level.lags.count + 1, Covariance::diagonal), Eigen::VectorXd()});
    }
}

void VelocityAutocorrelation::sample(const State& state, const Evaluation& /*evaluation*/) {
    ++samples_;
    const Eigen::VectorXd velocities = velocities_about_centre(state).reshaped();
    const std::optional<Eigen::VectorXd> sum = window_.add(velocities, state.execution());
    add_to_coarse(velocities, state.execution());
    if (!sum) {
        return;
    }
    const Index times = lags_.count + 1;
    const Eigen::VectorXd correlation = *sum / static_cast<double>(atoms_);
    AlignedVector<double> even(correlation.begin(), correlation.end());
    AlignedVector<double> spectrum(even.size());
    cosines_(even, spectrum);
    Eigen::VectorXd found(means_.width());
    found << correlation, running_integral(correlation, lags_.spacing) / 3.0,
        0.5 * lags_.spacing * Eigen::Map<const Eigen::VectorXd>(spectrum.data(), times),
        change_at_double_spacing(correlation, lags_.spacing) / 3.0;
    means_.add(found);
}

void VelocityAutocorrelation::add_to_coarse(Eigen::VectorXd velocities, const Execution& execution) {
    for (Coarse& level : coarse_) {
        if (level.pending.size() == 0) {
            level.pending = std::move(velocities);
            return;
        }
        velocities = 0.5 * (level.pending + velocities);
        level.pending.resize(0);
        if (const std::optional<Eigen::VectorXd> sum = level.window.add(velocities, execution)) {
            level.means.add(*sum / static_cast<double>(atoms_));
        }
    }
}

void VelocityAutocorrelation::interrupt() {
    window_.interrupt();
    for (Coarse& level : coarse_) {
        level.window.interrupt();
        level.pending.resize(0);
    }
}

void VelocityAutocorrelation::archive(Archive& a) {
    a(samples_, window_, means_);
    for (Coarse& level : coarse_) {
        a(level);
        if (level.pending.size() != 0 && level.pending.size() != 3 * atoms_) {
            throw CheckpointError("its mean velocities are of other atoms");
        }
    }
}

Estimate VelocityAutocorrelation::diffusion() const {
    return means_.estimate(2 * lags_.count + 1);
}

double VelocityAutocorrelation::change_of_diffusion() const {
    return means_.mean()[means_.width() - 1];
}

std::vector<DataTable> VelocityAutocorrelation::tables() const {
    if (means_.samples() == 0) {
        return {};
    }
    DataTable vacf{"vacf",
                   {"time", "vacf", "vacf_standard_error", "vacf_normalized", "diffusion", "diffusion_standard_error"},
                   {}};
    DataTable spectrum{"vibrational_spectrum", {"angular_frequency", "spectrum", "spectrum_standard_error"}, {}};
    const Index times = lags_.count + 1;
    const double at_zero = means_.mean()[0];
    const double to_spectrum = 2.0 / (std::numbers::pi * at_zero);
    const bool has_integrals = frames_are_close(diffusion(), change_of_diffusion());
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (Index k = 0; k < times; ++k) {
        const Estimate c = means_.estimate(k);
        const Estimate d = has_integrals ? means_.estimate(times + k) : Estimate{nan, nan, nan, 0, false};
        const Estimate s = means_.estimate(2 * times + k);
        vacf.rows.push_back({lags_.time(k), c.mean, c.standard_error, c.mean / at_zero, d.mean, d.standard_error});
        spectrum.rows.push_back({std::numbers::pi * static_cast<double>(k) / lags_.time(lags_.count),
                                 to_spectrum * s.mean, to_spectrum * s.standard_error});
    }
    add_long_times(vacf);
    return has_integrals ? std::vector{vacf, spectrum} : std::vector{vacf};
}

void VelocityAutocorrelation::add_long_times(DataTable& vacf) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const double at_zero = means_.mean()[0];
    for (const Coarse& level : coarse_) {
        const double known = vacf.rows.back()[0];
        for (Index k = 0; k <= level.lags.count && level.means.samples() > 0; ++k) {
            if (is_later(level.lags.time(k), known)) {
                const Estimate c = level.means.estimate(k);
                vacf.rows.push_back({level.lags.time(k), c.mean, c.standard_error, c.mean / at_zero, nan, nan});
            }
        }
    }
}

std::vector<ObservableAverage> VelocityAutocorrelation::observables() const {
    if (means_.samples() == 0) {
        return {};
    }
    if (atoms_ == 1) {
        return {average_of("diffusion_green_kubo", std::nullopt, moves_with_centre)};
    }
    return {green_kubo_integral(average_of("diffusion_green_kubo", diffusion()), change_of_diffusion())};
}

}  // namespace ljmd
