#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "ljmd/deck/deck.hpp"

namespace ljmd {

/// Which steps of a run are looked at: those of stages that are sampled, or all where none is. In a run of no steps,
/// its start is sampled.
class SampledSteps {
  public:
    explicit SampledSteps(const std::vector<Stage>& stages)
        : stages_(stages), all_(std::ranges::none_of(stages, &Stage::sample)) {}

    /// The stage that a step belongs to; nothing when that one is not looked at, or there is none.
    [[nodiscard]] std::optional<std::size_t> stage_of(Index step) const {
        Index before = 0;
        for (std::size_t k = 0; k < stages_.size(); ++k) {
            const Stage& stage = stages_[k];
            if (step > before && step <= before + stage.steps) {
                return all_ || stage.sample ? std::optional(k) : std::nullopt;
            }
            before += stage.steps;
        }
        return before == 0 && step == 0 ? std::optional<std::size_t>(0) : std::nullopt;
    }
    [[nodiscard]] bool contain(Index step) const { return stage_of(step).has_value(); }

  private:
    const std::vector<Stage>& stages_;
    bool all_;
};

/// Whether a time lies before another, and not merely by rounding.
[[nodiscard]] inline bool is_before(double time, double from) {
    return time < from - 1e-9 * std::abs(from);
}

}  // namespace ljmd
