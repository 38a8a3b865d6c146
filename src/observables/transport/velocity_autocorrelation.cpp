#include "ljmd/observables/transport/velocity_autocorrelation.hpp"

#include <limits>
#include <numbers>

#include "ljmd/observables/statistics/known_quantities.hpp"
#include "ljmd/observables/transport/centre_frame.hpp"
#include "ljmd/observables/transport/green_kubo.hpp"

namespace ljmd {

VelocityAutocorrelation::VelocityAutocorrelation(Index atoms, const LagTimes& lags, Index window)
    : atoms_(atoms),
      lags_(lags),
      every_(lags.every),
      cosines_(lags.count + 1),
      window_(3 * atoms, lags.count, window),
      means_(3 * (lags.count + 1) + 1, Covariance::diagonal) {}

void VelocityAutocorrelation::sample(const State& state, const Evaluation& /*evaluation*/) {
    ++samples_;
    const std::optional<Eigen::VectorXd> sum =
        window_.add(velocities_about_centre(state).reshaped(), state.execution());
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
    return has_integrals ? std::vector{vacf, spectrum} : std::vector{vacf};
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
