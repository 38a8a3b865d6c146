#include "ljmd/observables/transport/lag_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ljmd {

namespace {

/// Tolerance for ratios such as 2.0/0.05, which may be slightly below 40 in doubles.
constexpr double rounding = 1e-9;

Index whole_spacings(double time, double spacing) {
    return static_cast<Index>(std::floor(time / spacing * (1.0 + rounding)));
}

}  // namespace

std::vector<Key> lag_keys(const UsualLags& usual) {
    return {Key::integer("every")
                .at_least(1)
                .defaults_to(static_cast<std::int64_t>(usual.every))
                .meaning("steps between configurations"),
            Key::number("max_time")
                .dimension(Dimension::time)
                .unit("tau")
                .above(0.0)
                .optional(fmt::format("{} tau, or {} of the longest sampled stage if that is shorter", usual.max_time,
                                      usual.share))
                .meaning("largest time between two configurations")};
}

LagTimes lag_times(const Section& section, const SampledRun& run, const UsualLags& usual) {
    const Index every = section.integer("every");
    const double spacing = static_cast<double>(every) * run.time_step;
    const double usual_time = std::min(usual.max_time, usual.share * static_cast<double>(run.steps) * run.time_step);
    const double time = section.has("max_time") ? section.number("max_time") : usual_time;
    return {every, std::max(whole_spacings(time, spacing), Index{1}), spacing};
}

Index correlation_window(const LagTimes& lags, const SampledRun& run) {
    return std::clamp(run.steps / lags.every, lags.count + 1, 2 * lags.count);
}

std::vector<std::pair<std::string, std::string>> lag_mistakes(const Section& section, const SampledRun& run,
                                                              const UsualLags& usual, const std::string& analysis) {
    std::vector<std::pair<std::string, std::string>> mistakes;
    const LagTimes lags = lag_times(section, run, usual);
    if (!section.has("max_time")) {
        return mistakes;
    }
    const double time = section.number("max_time");
    if (whole_spacings(time, lags.spacing) < 1) {
        mistakes.emplace_back("max_time",
                              fmt::format("'max_time' in {} is {:.6g}, but configurations are {:.6g} tau apart "
                                          "(`every` = {} steps)",
                                          analysis, time, lags.spacing, lags.every));
    } else if (run.steps > 0 && lags.count > run.steps / lags.every) {
        mistakes.emplace_back(
            "max_time", fmt::format("'max_time' in {} is {:.6g}, but no more than {:.6g} tau are sampled at a stretch",
                                    analysis, time, static_cast<double>(run.steps) * run.time_step));
    }
    return mistakes;
}

}  // namespace ljmd
