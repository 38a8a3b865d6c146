#include "ljmd/observables/transport/velocity_autocorrelation.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual{.every = 5, .max_time = 4.0, .share = 0.1};

}  // namespace

/// Velocity autocorrelation, see velocity_autocorrelation.hpp.
AnalysisMethod vacf() {
    return {.name = "vacf",
            .meaning =
                "velocity autocorrelation, diffusion by Green and Kubo and vibrational spectrum, written to "
                "vacf.csv and vibrational_spectrum.csv",
            .files = {"vacf", "vibrational_spectrum"},
            .follows_time = true,
            .needs = {.velocities = true},
            .keys = lag_keys(usual),
            .check = [](const Section& section,
                        const SampledRun& run) { return lag_mistakes(section, run, usual, "vacf"); },
            .make = [](const Section& section, const SampledRun& run) -> std::unique_ptr<Analysis> {
                const LagTimes lags = lag_times(section, run, usual);
                return std::make_unique<VelocityAutocorrelation>(run.atoms, lags, correlation_window(lags, run));
            },
            .size = [](const Section& section, const SampledRun& run) -> AnalysisSize {
                const LagTimes lags = lag_times(section, run, usual);
                const Index window = correlation_window(lags, run);
                const Index frames = run.steps / lags.every + 1;
                const double frame = 24.0 * static_cast<double>(run.atoms);
                return {.kept = frame * static_cast<double>(std::min(frames, window)) +
                                BlockingAccumulator::bytes(3 * lags.count + 4, Covariance::diagonal, frames / window),
                        .passing = frame};
            }};
}

}  // namespace ljmd
