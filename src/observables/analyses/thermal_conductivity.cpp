#include "observables/transport/heat_flux_autocorrelation.hpp"

namespace ljmd {

namespace {

// A sample takes as long as eight steps. With dt = 0.004 the integral of a liquid changes by 0.06 % from every = 5
// to 10.
constexpr UsualLags usual_conductivity_lags{.every = 10, .max_time = 3.0, .share = 0.05};

struct ThermalConductivityOptions : AnalysisOptions {
    LagOptions lags{usual_conductivity_lags};

    void describe(Description& description) override { lags.describe(description); }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        return lags.check(run, "thermal_conductivity");
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        return std::make_unique<HeatFluxAutocorrelation>(run, times, correlation_window(times, run));
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        const Index window = correlation_window(times, run);
        const Index frames = run.steps / times.every + 1;
        return {.kept = 24.0 * static_cast<double>(std::min(frames, window)) +
                        BlockingAccumulator::bytes(2 * times.count + 5, Covariance::diagonal, frames / window),
                .passing = 2.0 * 8.0 * vector_stride * static_cast<double>(run.atoms)};
    }
};

}  // namespace

/// Thermal conductivity, see heat_flux_autocorrelation.hpp.
AnalysisMethod thermal_conductivity() {
    return {.name = "thermal_conductivity",
            .meaning =
                "thermal conductivity by Green and Kubo, written with the autocorrelation of the heat flux to "
                "heat_flux_autocorrelation.csv; not with truncation = \"cut\"",
            .files = {"heat_flux_autocorrelation"},
            .follows_time = true,
            .needs = {.velocities = true, .interaction = true, .continuous_potential = true, .homogeneous = true},
            .quantities = {{"thermal_conductivity", "lambda", "k_B/(sigma tau)"},
                           {"heat_flux_autocorrelation", "<J(0) J(t)>", "epsilon^2/(sigma^4 tau^2)"}},
            .charts = {{.file = "heat_flux_autocorrelation",
                        .x = "time",
                        .y = "thermal_conductivity",
                        .title = "Thermal conductivity up to this time"}},
            .options = [] { return std::make_unique<ThermalConductivityOptions>(); }};
}

}  // namespace ljmd
