#include <fmt/format.h>

#include "ljmd/observables/transport/mean_square_displacement.hpp"

namespace ljmd {

namespace {

constexpr UsualLags usual{.every = 50, .max_time = 10.0, .share = 0.2};
constexpr double usual_fit_start = 0.2;  // fraction of the largest time: beyond the motion of an atom in its cage

LagTimes times_of(const Section& section, const SampledRun& run) {
    LagTimes lags = lag_times(section, run, usual);
    lags.count = std::max(lags.count, Index{2});  // a line needs two times after the first
    return lags;
}

double fit_start(const Section& section, const LagTimes& lags) {
    return section.has("fit_start") ? section.number("fit_start") : usual_fit_start * lags.time(lags.count);
}

std::vector<std::pair<std::string, std::string>> mistakes(const Section& section, const SampledRun& run) {
    std::vector<std::pair<std::string, std::string>> found = lag_mistakes(section, run, usual, "msd");
    const LagTimes lags = times_of(section, run);
    const double last_start = lags.time(lags.count - 1);
    if (section.has("fit_start") && section.number("fit_start") > last_start * (1.0 + 1e-9)) {
        found.emplace_back("fit_start", fmt::format("'fit_start' in msd is {:.6g}: a line needs at least two times, so "
                                                    "it can be at most {:.6g}",
                                                    section.number("fit_start"), last_start));
    }
    return found;
}

AnalysisSize size_of(const Section& section, const SampledRun& run) {
    const LagTimes lags = times_of(section, run);
    const Index frames = run.steps / lags.every + 1;
    const Index between =
        std::max((lags.count + section.integer("origins") - 1) / section.integer("origins"), Index{1});
    const Index whole_origins = (std::min(frames, lags.count) + between - 1) / between;
    const auto origins = static_cast<double>(whole_origins);
    const double positions = 24.0 * static_cast<double>(run.atoms);
    return {.kept = origins * (positions + 4.0 * static_cast<double>(lags.count)) +
                    BlockingAccumulator::bytes(lags.count + 2, Covariance::diagonal, (frames - lags.count) / between),
            .passing = positions};
}

}  // namespace

/// Mean-square displacement, see mean_square_displacement.hpp.
AnalysisMethod msd() {
    std::vector<Key> keys = lag_keys(usual);
    keys.push_back(Key::integer("origins")
                       .at_least(1)
                       .at_most(100000)
                       .defaults_to(std::int64_t{50})
                       .meaning("time origins within `max_time`; each takes 24 bytes an atom"));
    keys.push_back(Key::number("fit_start")
                       .dimension(Dimension::time)
                       .unit("tau")
                       .at_least(0.0)
                       .optional(fmt::format("{} of `max_time`", usual_fit_start))
                       .meaning("diffusion is the slope from this time to `max_time`"));
    return {.name = "msd",
            .meaning = "mean-square displacement and diffusion by Einstein's relation, written to msd.csv",
            .files = {"msd"},
            .follows_time = true,
            .needs = {.unwrapped_positions = true},
            .keys = keys,
            .check = mistakes,
            .make = [](const Section& section, const SampledRun& run) -> std::unique_ptr<Analysis> {
                const LagTimes lags = times_of(section, run);
                return std::make_unique<MeanSquareDisplacement>(run.atoms, lags, section.integer("origins"),
                                                                fit_start(section, lags));
            },
            .size = size_of};
}

}  // namespace ljmd
