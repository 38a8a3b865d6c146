#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "observables/dynamics/distinct_van_hove.hpp"

namespace ljmd {

namespace {

constexpr double usual_radius = 5.0;
constexpr UsualLags usual_distance_lags{.every = 50, .max_time = 1.0, .share = 0.1};

struct VanHoveDistinctOptions : AnalysisOptions {
    LagOptions lags{usual_distance_lags};
    double between = 16.0;
    Index bins = 100;
    std::optional<double> radius = {};

    void describe(Description& description) override {
        lags.describe(description);
        description.number("between", between)
            .dimension(Dimension::time)
            .unit("tau")
            .above(0.0)
            .meaning(
                "from one time origin to the next, at least `max_time`: each time of an origin takes N^2 distances");
        description.integer("bins", bins).at_least(1).at_most(10000).meaning("bins between 0 and `radius`");
        description.number("radius", radius)
            .dimension(Dimension::length)
            .unit("sigma")
            .above(0.0)
            .optional(fmt::format("{} sigma or L/2, whichever is smaller", usual_radius))
            .meaning("largest distance, at most L/2");
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        Misfits misfits = lags.check(run, "van_hove_distinct");
        const double half = 0.5 * run.box.edges().minCoeff();
        if (radius && *radius > half * (1.0 + 1e-12)) {
            misfits.emplace_back("radius", fmt::format("'radius' in van_hove_distinct is {:.6g}, more than half of the "
                                                       "shortest edge of the box, {:.6g}",
                                                       *radius, half));
        }
        return misfits;
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const double half = 0.5 * run.box.edges().minCoeff();
        const LagTimes times = lags.times(run);
        return std::make_unique<DistinctVanHove>(
            run.atoms, times, between_of(times),
            DistanceBins{std::min(radius.value_or(std::min(usual_radius, half)), half), bins});
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        const LagTimes times = lags.times(run);
        const double positions = 24.0 * static_cast<double>(run.atoms);
        const Index width = bins * (times.count + 1);
        const Index frames = run.steps / times.every;
        const Index origins = frames > times.count ? (frames - times.count - 1) / between_of(times) + 1 : 0;
        return {.kept = positions + 8.0 * static_cast<double>(width) +
                        BlockingAccumulator::bytes(width, Covariance::diagonal, origins),
                .passing = positions};
    }

  private:
    [[nodiscard]] Index between_of(const LagTimes& times) const {
        return std::max(static_cast<Index>(std::lround(between / times.spacing)), times.count);
    }
};

}  // namespace

/// Distinct part of van Hove's function, see distinct_van_hove.hpp.
AnalysisMethod van_hove_distinct() {
    return {.name = "van_hove_distinct",
            .meaning =
                "where other atoms are a time after an atom was at the origin, van Hove's G_d(r, t), written to gd.csv",
            .files = {"gd"},
            .follows_time = true,
            .needs = {.unwrapped_positions = true},
            .quantities = {{"G_d", "G_d(r, t)", "sigma^-3"}},
            .charts = {{.file = "gd",
                        .x = "r",
                        .y = "G_d",
                        .title = "Other atoms around an atom's place, by time",
                        .group = "time"}},
            .options = [] { return std::make_unique<VanHoveDistinctOptions>(); }};
}

}  // namespace ljmd
