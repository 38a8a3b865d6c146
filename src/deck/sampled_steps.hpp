#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "deck/deck.hpp"

namespace ljmd {

/// The steps of a run that are sampled: the steps of sampled stages, or all if no stage is sampled. In a run of 0 steps
/// the start is sampled.
class SampledSteps {
  public:
    explicit SampledSteps(const std::vector<Stage>& stages)
        : stages_(stages), all_(std::ranges::none_of(stages, &Stage::sample)) {}

    /// The stage of a step; nothing if the step is not sampled or outside the run.
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

/// Whether a time is before another one by more than rounding.
[[nodiscard]] inline bool is_before(double time, double from) {
    return time < from - 1e-9 * std::abs(from);
}

}  // namespace ljmd
