#include "ljmd/observables/transport/stress_autocorrelation.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual{.every = 5, .max_time = 5.0, .share = 0.05};

}  // namespace

/// Shear viscosity, see stress_autocorrelation.hpp.
AnalysisMethod viscosity() {
    return {.name = "viscosity",
            .meaning =
                "shear viscosity by Green and Kubo, written with the stress autocorrelation to "
                "stress_autocorrelation.csv",
            .files = {"stress_autocorrelation"},
            .follows_time = true,
            .needs = {.velocities = true, .interaction = true},
            .keys = lag_keys(usual),
            .check = [](const Section& section,
                        const SampledRun& run) { return lag_mistakes(section, run, usual, "viscosity"); },
            .make = [](const Section& section, const SampledRun& run) -> std::unique_ptr<Analysis> {
                const LagTimes lags = lag_times(section, run, usual);
                return std::make_unique<StressAutocorrelation>(run.box, lags, correlation_window(lags, run));
            },
            .size = [](const Section& section, const SampledRun& run) -> AnalysisSize {
                const LagTimes lags = lag_times(section, run, usual);
                const Index window = correlation_window(lags, run);
                const Index frames = run.steps / lags.every + 1;
                return {.kept = 48.0 * static_cast<double>(std::min(frames, window)) +
                                BlockingAccumulator::bytes(2 * lags.count + 4, Covariance::diagonal, frames / window)};
            }};
}

}  // namespace ljmd
