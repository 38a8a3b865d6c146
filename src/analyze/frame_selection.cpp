#include "analyze/frame_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Times may be rounded to single precision.
constexpr double time_rounding = 2.0 * std::numeric_limits<float>::epsilon();
constexpr double default_rounding = 1e-3;  // relative to the spacing

/// The times of all frames; empty if unknown.
std::vector<double> times_of(const TrajectorySummary& trajectory, std::optional<double> time_step) {
    if (!trajectory.times.empty() || !time_step) {
        return trajectory.times;
    }
    std::vector<double> times;
    for (std::size_t k = 0; k < static_cast<std::size_t>(trajectory.frames); ++k) {
        const double step = static_cast<double>(trajectory.steps.empty() ? static_cast<Index>(k) : trajectory.steps[k]);
        times.push_back(step * *time_step);
    }
    return times;
}

/// Frames that follow another one in the same part.
std::vector<std::size_t> followers(const FrameSelection& selection) {
    std::vector<std::size_t> found;
    for (std::size_t k = 1; k < selection.parts.size(); ++k) {
        if (selection.parts[k] && selection.parts[k] == selection.parts[k - 1]) {
            found.push_back(k);
        }
    }
    return found;
}

/// The common number of steps between them; nothing if it varies.
std::optional<Index> common_steps(const std::vector<std::size_t>& followers, const std::vector<Index>& steps) {
    std::optional<Index> apart;
    for (const std::size_t k : followers) {
        const Index here = steps.empty() ? 0 : steps[k] - steps[k - 1];
        if (here <= 0 || (apart && here != *apart)) {
            return std::nullopt;
        }
        apart = here;
    }
    return apart;
}

/// The common spacing in time, or why there is none. For rounded times, the time step determines the exact spacing.
void find_spacing(FrameSelection& selection, const std::vector<double>& times, std::optional<double> time_step) {
    const std::vector<std::size_t> pairs = followers(selection);
    if (times.empty()) {
        selection.uneven = "the frames have no times: --time-step gives the time between steps, or a deck with --deck";
        return;
    }
    if (pairs.empty()) {
        selection.uneven = "no two frames follow each other";
        return;
    }
    const std::size_t first = pairs.front();
    const double apart = times[first] - times[first - 1];
    for (const std::size_t k : pairs) {
        const double here = times[k] - times[k - 1];
        if (!(apart > 0.0) ||
            !(std::abs(here - apart) < default_rounding * apart + time_rounding * std::abs(times[k]))) {
            selection.uneven = fmt::format("frames {} and {} are {:.6g} tau apart, frames {} and {} are {:.6g} tau",
                                           first, first + 1, apart, k, k + 1, here);
            return;
        }
    }
    double sum = 0.0;
    for (const std::size_t k : pairs) {
        sum += times[k] - times[k - 1];
    }
    const double mean = sum / static_cast<double>(pairs.size());
    const double meant =
        time_step && selection.steps_apart ? *time_step * static_cast<double>(*selection.steps_apart) : mean;
    selection.spacing = std::abs(meant - mean) < default_rounding * mean ? meant : mean;
}

}  // namespace

FrameSelection select_frames(const TrajectorySummary& trajectory, std::optional<double> time_step,
                             const std::vector<Stage>* stages, std::optional<double> from) {
    const std::vector<double> times = times_of(trajectory, time_step);
    if (from && times.empty()) {
        throw InputError("--from: the frames have no times; --time-step gives the time between steps");
    }
    FrameSelection selection{};
    std::map<std::size_t, Index> in_part;
    std::size_t breaks = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(trajectory.frames); ++k) {
        const bool early = from && is_before(times[k], *from);
        std::optional<std::size_t> part = 0;
        if (stages != nullptr && !trajectory.steps.empty()) {
            part = SampledSteps(*stages).stage_of(trajectory.steps[k]);
        }
        breaks += std::ranges::binary_search(trajectory.breaks, k) ? 1U : 0U;
        if (part) {
            *part += breaks * (stages != nullptr ? stages->size() : 1);
        }
        selection.parts.push_back(early ? std::nullopt : part);
        if (selection.parts.back()) {
            ++selection.used;
            selection.longest_part = std::max(selection.longest_part, ++in_part[*part]);
        }
    }
    if (selection.used == 0) {
        throw DataError(fmt::format("none of the {} frames is {}", trajectory.frames,
                                    from ? fmt::format("as late as --from {}", *from) : "of a sampled stage"));
    }
    selection.steps_apart = common_steps(followers(selection), trajectory.steps);
    find_spacing(selection, times, time_step);
    for (Index k = 0; k < trajectory.frames; ++k) {
        const auto frame = static_cast<std::size_t>(k);
        selection.numbers.push_back(selection.steps_apart ? trajectory.steps[frame] / *selection.steps_apart : k);
    }
    return selection;
}

}  // namespace ljmd
