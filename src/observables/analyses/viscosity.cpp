#include "ljmd/observables/stress_autocorrelation.hpp"

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
            }};
}

}  // namespace ljmd
