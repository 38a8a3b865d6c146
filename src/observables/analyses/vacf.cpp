#include "observables/transport/long_times.hpp"
#include "observables/transport/velocity_autocorrelation.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual_vacf_lags{.every = 5, .max_time = 4.0, .share = 0.1};

struct VacfOptions : AnalysisOptions {
    LagOptions lags{usual_vacf_lags};
    LongTimeOption long_times;

    void describe(Description& description) override {
        lags.describe(description);
        long_times.describe(description);
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        Misfits misfits = lags.check(run, "vacf");
        long_times.check(lags.times(run), run, "vacf", misfits);
        return misfits;
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        std::vector<VelocityAutocorrelation::Level> levels;
        for (const LagTimes& times : long_times.levels(lags.times(run))) {
            levels.push_back({times, correlation_window(times, run)});
        }
        return std::make_unique<VelocityAutocorrelation>(run.atoms, levels);
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const LagTimes first = lags.times(run);
        return with_long_times_size(long_times, first, [&](const LagTimes& times) -> AnalysisSize {
            const bool is_first = times.every == first.every;
            const Index window = correlation_window(times, run);
            const Index frames = run.steps / times.every + 1;
            const double frame = 24.0 * static_cast<double>(run.atoms);
            return {.kept = frame * static_cast<double>(std::min(frames, window) + (is_first ? 0 : 1)) +
                            BlockingAccumulator::bytes(is_first ? 3 * times.count + 4 : times.count + 1,
                                                       Covariance::diagonal, frames / window),
                    .passing = frame};
        });
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
