#include <fmt/format.h>

#include "observables/transport/pressure_autocorrelation.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual_bulk_viscosity_lags{.every = 5, .max_time = 3.0, .share = 0.05};

struct BulkViscosityOptions : AnalysisOptions {
    LagOptions lags{usual_bulk_viscosity_lags};

    void describe(Description& description) override { lags.describe(description); }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        Misfits found = lags.check(run, "bulk_viscosity");
        const LagTimes times = lags.times(run);
        if (found.empty() && lags.max_time && run.steps > 0 &&
            PressureAutocorrelation::shortest_stage * times.count > run.steps / times.every) {
            found.emplace_back(
                "max_time",
                fmt::format("'max_time' in bulk_viscosity is {:.6g}: the mean pressure, which is taken off, "
                            "needs {} times as long, and no more than {:.6g} tau are sampled at a stretch",
                            times.time(times.count), PressureAutocorrelation::shortest_stage,
                            static_cast<double>(run.steps) * run.time_step));
        }
        return found;
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        return std::make_unique<PressureAutocorrelation>(run.box, times, correlation_window(times, run));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        const Index frames = run.steps / times.every + 1;
        return {.kept = 8.0 * static_cast<double>(frames)};
    }
};

}  // namespace

/// Bulk viscosity, see pressure_autocorrelation.hpp.
AnalysisMethod bulk_viscosity() {
    return {.name = "bulk_viscosity",
            .meaning =
                "bulk viscosity by Green and Kubo, written with the autocorrelation of the pressure to "
                "pressure_autocorrelation.csv; only at constant energy, and not with truncation = \"cut\"",
            .files = {"pressure_autocorrelation"},
            .follows_time = true,
            .needs = {.velocities = true,
                      .interaction = true,
                      .continuous_potential = true,
                      .constant_energy = true,
                      .homogeneous = true},
            .quantities = {{"bulk_viscosity", "eta_v", "epsilon tau/sigma^3"},
                           {"pressure_autocorrelation", "<dp(0) dp(t)>", "epsilon^2/sigma^6"}},
            .charts = {{.file = "pressure_autocorrelation",
                        .x = "time",
                        .y = "bulk_viscosity",
                        .title = "Bulk viscosity up to this time"}},
            .options = [] { return std::make_unique<BulkViscosityOptions>(); }};
}

}  // namespace ljmd
