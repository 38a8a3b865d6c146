#include <fmt/format.h>

#include "observables/dynamics/self_van_hove.hpp"
#include "observables/transport/time_origins.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual_displacement_lags{.every = 10, .max_time = 4.0, .share = 0.1};

struct VanHoveOptions : AnalysisOptions {
    LagOptions lags{usual_displacement_lags};
    Index origins = 10;
    Index times = 10;
    Index bins = 100;
    double radius = 3.0;

    void describe(Description& description) override {
        lags.describe(description);
        description.integer("origins", origins)
            .at_least(1)
            .at_most(100000)
            .meaning("time origins within `max_time`; each takes 24 bytes an atom");
        description.integer("times", times)
            .at_least(1)
            .at_most(1000)
            .meaning("G_s is given at so many times, equally spaced up to `max_time`; fewer if there are fewer");
        description.integer("bins", bins).at_least(1).at_most(10000).meaning("bins between 0 and `radius`");
        description.number("radius", radius)
            .dimension(Dimension::length)
            .unit("sigma")
            .above(0.0)
            .meaning("largest displacement that is counted in G_s");
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override { return lags.check(run, "van_hove"); }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const LagTimes of_run = lags.times(run);
        return std::make_unique<SelfVanHove>(run.atoms, of_run, origins,
                                             DisplacementBins{radius, bins, std::min(times, of_run.count)});
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const LagTimes of_run = lags.times(run);
        const Index frames = run.steps / of_run.every + 1;
        const Index between = frames_between_origins(of_run, origins);
        const Index added = std::max((frames - of_run.count) / between, Index{0});
        const Index open = (std::min(frames, of_run.count) + between - 1) / between;
        const auto kept = static_cast<double>(open);
        const double positions = 24.0 * static_cast<double>(run.atoms);
        const double counted = 8.0 * static_cast<double>(bins * times);
        return {.kept = kept * (positions + 8.0 * static_cast<double>(of_run.count) + 0.5 * counted) +
                        BlockingAccumulator::bytes(bins * times, Covariance::diagonal, added) +
                        static_cast<double>(of_run.count) * BlockingAccumulator::bytes(2, Covariance::full, added),
                .passing = positions};
    }
};

}  // namespace

/// Distribution of displacements, see self_van_hove.hpp.
AnalysisMethod van_hove() {
    return {
        .name = "van_hove",
        .meaning =
            "distribution of the displacements of single atoms, van Hove's G_s(r, t), written to gs.csv, and the "
            "non-Gaussian parameter alpha_2(t), to alpha2.csv",
        .files = {"alpha2", "gs"},
        .follows_time = true,
        .needs = {.unwrapped_positions = true},
        .quantities = {{"alpha_2", "alpha_2", ""}, {"G_s", "G_s(r, t)", "sigma^-3"}},
        .charts = {{.file = "alpha2",
                    .x = "time",
                    .y = "alpha_2",
                    .title = "Non-Gaussian parameter",
                    .level = 0.0,
                    .level_label = "normal distribution"},
                   {.file = "gs", .x = "r", .y = "G_s", .title = "Displacements of atoms, by time", .group = "time"}},
        .options = [] { return std::make_unique<VanHoveOptions>(); }};
}

}  // namespace ljmd
