#include "observables/transport/lag_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ljmd {

namespace {

/// Tolerance for ratios such as 2.0/0.05, which may be slightly below 40 in doubles.
constexpr double rounding_of_ratios = 1e-9;

Index whole_spacings(double time, double spacing) {
    return static_cast<Index>(std::floor(time / spacing * (1.0 + rounding_of_ratios)));
}

}  // namespace

void LagOptions::describe(Description& description) {
    description.integer("every", every).at_least(1).step_interval().meaning("steps between configurations");
    description.number("max_time", max_time)
        .dimension(Dimension::time)
        .unit("tau")
        .above(0.0)
        .optional(
            fmt::format("{} tau, or {} of the longest sampled stage if that is shorter", usual_.max_time, usual_.share))
        .meaning("largest time between two configurations");
}

LagTimes LagOptions::times(const SampledRun& run) const {
    const double spacing = static_cast<double>(every) * run.time_step;
    const double default_time =
        std::min(usual_.max_time, usual_.share * static_cast<double>(run.steps) * run.time_step);
    return {every, std::max(whole_spacings(max_time.value_or(default_time), spacing), Index{1}), spacing};
}

Index correlation_window(const LagTimes& lags, const SampledRun& run) {
    return std::clamp(run.steps / lags.every, lags.count + 1, 2 * lags.count);
}

Misfits LagOptions::check(const SampledRun& run, const std::string& analysis) const {
    if (!max_time) {
        return {};
    }
    const LagTimes lags = times(run);
    if (whole_spacings(*max_time, lags.spacing) < 1) {
        return {{"max_time", fmt::format("'max_time' in {} is {:.6g}, but configurations are {:.6g} tau apart "
                                         "(`every` = {} steps)",
                                         analysis, *max_time, lags.spacing, lags.every)}};
    }
    if (run.steps > 0 && lags.count > run.steps / lags.every) {
        return {{"max_time", fmt::format("'max_time' in {} is {:.6g}, but no more than {:.6g} tau are sampled at a "
                                         "stretch",
                                         analysis, *max_time, static_cast<double>(run.steps) * run.time_step)}};
    }
    return {};
}

}  // namespace ljmd
