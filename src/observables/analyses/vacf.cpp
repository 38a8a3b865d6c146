#include "ljmd/observables/transport/velocity_autocorrelation.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual_vacf_lags{.every = 5, .max_time = 4.0, .share = 0.1};

struct VacfOptions : AnalysisOptions {
    LagOptions lags{usual_vacf_lags};

    void describe(Description& description) override { lags.describe(description); }
    [[nodiscard]] Misfits check(const SampledRun& run) const override { return lags.check(run, "vacf"); }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        return std::make_unique<VelocityAutocorrelation>(run.atoms, times, correlation_window(times, run));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        const Index window = correlation_window(times, run);
        const Index frames = run.steps / times.every + 1;
        const double frame = 24.0 * static_cast<double>(run.atoms);
        return {.kept = frame * static_cast<double>(std::min(frames, window)) +
                        BlockingAccumulator::bytes(3 * times.count + 4, Covariance::diagonal, frames / window),
                .passing = frame};
    }
};

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
            .quantities = {{"vacf", "<v(0) v(t)>", "sigma^2/tau^2"},
                           {"vacf_normalized", "<v(0) v(t)>/<v^2>", ""},
                           {"diffusion", "D", "sigma^2/tau"},
                           {"diffusion_green_kubo", "D_GK", "sigma^2/tau"},
                           {"angular_frequency", "omega tau", ""},
                           {"spectrum", "spectrum", ""}},
            .charts = {{.file = "vacf",
                        .x = "time",
                        .y = "vacf",
                        .title = "Velocity autocorrelation",
                        .level = 0.0,
                        .level_label = "no correlation"},
                       {.file = "vacf", .x = "time", .y = "diffusion", .title = "Diffusion up to this time"},
                       {.file = "vibrational_spectrum",
                        .x = "angular_frequency",
                        .y = "spectrum",
                        .title = "Vibrational spectrum"}},
            .options = [] { return std::make_unique<VacfOptions>(); }};
}

}  // namespace ljmd
