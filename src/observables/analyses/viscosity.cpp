#include "observables/transport/stress_autocorrelation.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual_viscosity_lags{.every = 5, .max_time = 5.0, .share = 0.05};

struct ViscosityOptions : AnalysisOptions {
    LagOptions lags{usual_viscosity_lags};

    void describe(Description& description) override { lags.describe(description); }
    [[nodiscard]] Misfits check(const SampledRun& run) const override { return lags.check(run, "viscosity"); }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        return std::make_unique<StressAutocorrelation>(run.box, times, correlation_window(times, run));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        const Index window = correlation_window(times, run);
        const Index frames = run.steps / times.every + 1;
        return {.kept = 48.0 * static_cast<double>(std::min(frames, window)) +
                        BlockingAccumulator::bytes(2 * times.count + 4, Covariance::diagonal, frames / window)};
    }
};

}  // namespace

/// Shear viscosity, see stress_autocorrelation.hpp.
AnalysisMethod viscosity() {
    return {.name = "viscosity",
            .meaning =
                "shear viscosity by Green and Kubo, written with the stress autocorrelation to "
                "stress_autocorrelation.csv",
            .files = {"stress_autocorrelation"},
            .follows_time = true,
            .needs = {.velocities = true, .interaction = true, .homogeneous = true},
            .quantities = {{"viscosity", "eta", "epsilon tau/sigma^3"},
                           {"stress_autocorrelation", "<s(0) s(t)>", "epsilon^2/sigma^6"}},
            .charts = {{.file = "stress_autocorrelation",
                        .x = "time",
                        .y = "viscosity",
                        .title = "Viscosity up to this time"}},
            .options = [] { return std::make_unique<ViscosityOptions>(); }};
}

}  // namespace ljmd
