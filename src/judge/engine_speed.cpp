#include "judge/engine_speed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ljmd {

namespace {

constexpr std::size_t rounds_of_speed = 3;
constexpr Index shorter = 5;

/// Times of a shorter and a longer run.
struct Times {
    std::array<double, rounds_of_speed> of_short{};
    std::array<double, rounds_of_speed> of_long{};
};

double median_of(std::array<double, rounds_of_speed> times) {
    std::ranges::sort(times);
    return times[rounds_of_speed / 2];
}

}  // namespace

std::optional<EngineSpeed> compare_speed(const SecondsOfRun& ours, const SecondsOfRun& theirs, Index steps,
                                         Index every) {
    const Index few = std::max<Index>(1, steps / shorter / every) * every;
    Times our_times;
    Times their_times;
    for (std::size_t round = 0; round < rounds_of_speed; ++round) {
        for (const auto& [seconds, times] : {std::pair(&ours, &our_times), std::pair(&theirs, &their_times)}) {
            times->of_short[round] = (*seconds)(few);
            times->of_long[round] = (*seconds)(steps);
        }
    }
    const auto speed = [&](const Times& times) {
        return static_cast<double>(steps - few) / (median_of(times.of_long) - median_of(times.of_short));
    };
    const double our_speed = speed(our_times);
    const double their_speed = speed(their_times);
    const auto is_known = [](double v) { return v > 0.0 && std::isfinite(v); };
    if (!is_known(our_speed) || !is_known(their_speed)) {
        return std::nullopt;
    }
    const double beside = median_of(their_times.of_long) - static_cast<double>(steps) / their_speed;
    return EngineSpeed{our_speed, their_speed, std::max(0.0, beside), steps};
}

}  // namespace ljmd
