#include <fmt/format.h>

#include "observables/transport/long_times.hpp"
#include "observables/transport/mean_square_displacement.hpp"
#include "observables/transport/time_origins.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual_msd_lags{.every = 50, .max_time = 10.0, .share = 0.2};
constexpr double default_fit_start = 0.2;  // fraction of the largest time: beyond the motion of an atom in its cage

struct MsdOptions : AnalysisOptions {
    LagOptions lags{usual_msd_lags};
    Index origins = 50;
    std::optional<double> fit_start = {};
    LongTimeOption long_times;

    void describe(Description& description) override {
        lags.describe(description);
        description.integer("origins", origins)
            .at_least(1)
            .at_most(100000)
            .meaning("time origins within `max_time`; each takes 24 bytes an atom");
        description.number("fit_start", fit_start)
            .dimension(Dimension::time)
            .unit("tau")
            .at_least(0.0)
            .optional(fmt::format("{} of `max_time`", default_fit_start))
            .meaning("diffusion is the slope from this time to `max_time`");
        long_times.describe(description);
    }
    [[nodiscard]] Misfits check(const SampledRun& run) const override {
        Misfits misfits = lags.check(run, "msd");
        const LagTimes times = times_of(run);
        const double last_start = times.time(times.count - 1);
        if (fit_start && *fit_start > last_start * (1.0 + 1e-9)) {
            misfits.emplace_back("fit_start", fmt::format("'fit_start' in msd is {:.6g}: a line needs at least two "
                                                          "times, so it can be at most {:.6g}",
                                                          *fit_start, last_start));
        }
        long_times.check(times, run, "msd", misfits);
        return misfits;
    }
    [[nodiscard]] std::unique_ptr<Analysis> make(const SampledRun& run) const override {
        const LagTimes first = times_of(run);
        return with_long_times(long_times, first, [&](const LagTimes& times) {
            const double start =
                times.every == first.every ? fit_start.value_or(default_fit_start * times.time(times.count)) : 0.0;
            return std::make_unique<MeanSquareDisplacement>(run.atoms, times, origins, start);
        });
    }
    [[nodiscard]] AnalysisSize size(const SampledRun& run) const override {
        return with_long_times_size(long_times, times_of(run), [&](const LagTimes& times) -> AnalysisSize {
            const Index frames = run.steps / times.every + 1;
            const Index between = frames_between_origins(times, origins);
            const Index whole_origins = (std::min(frames, times.count) + between - 1) / between;
            const auto kept = static_cast<double>(whole_origins);
            const double positions = 24.0 * static_cast<double>(run.atoms);
            const Index added = std::max((frames - times.count) / between, Index{0});
            return {.kept = kept * (positions + 4.0 * static_cast<double>(times.count)) +
                            BlockingAccumulator::bytes(times.count + 2, Covariance::diagonal, added),
                    .passing = positions};
        });
    }

  private:
    [[nodiscard]] LagTimes times_of(const SampledRun& run) const {
        LagTimes times = lags.times(run);
        times.count = std::max(times.count, Index{2});  // a line needs two times after the first
        return times;
    }
};

}  // namespace

/// Mean-square displacement, see mean_square_displacement.hpp.
AnalysisMethod msd() {
    return {
        .name = "msd",
        .meaning = "mean-square displacement and diffusion by Einstein's relation, written to msd.csv",
        .files = {"msd"},
        .follows_time = true,
        .needs = {.unwrapped_positions = true},
        .quantities = {{"msd", "<dr^2>", "sigma^2"},
                       {"diffusion", "D", "sigma^2/tau"},
                       {"diffusion_infinite_system", "D_inf", "sigma^2/tau"}},
        .charts =
            {{.file = "msd", .x = "time", .y = "msd", .title = "Mean-square displacement", .is_power_of_time = true}},
        .options = [] { return std::make_unique<MsdOptions>(); }};
}

}  // namespace ljmd
