#include "engine/errors_to_reach.hpp"

#include <algorithm>
#include <limits>

namespace ljmd {

namespace {

/// The errors that a stage is to reach are shown each time the samples have grown by this share.
constexpr Index shown_share = 64;

std::vector<ErrorSoFar> errors_of(const Stage& stage, const RunAverages& of_run) {
    std::vector<ErrorSoFar> errors;
    errors.reserve(stage.until.size());
    const std::vector<ObservableAverage> averages = of_run.averages();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const WantedError& wanted : stage.until) {
        const auto found = std::ranges::find(averages, wanted.observable, &ObservableAverage::name);
        if (found == averages.end() || !found->estimate) {
            errors.push_back({wanted, nan, nan, false});
        } else {
            const Estimate estimate = stopped_estimate(*found->estimate);
            errors.push_back(
                {wanted, estimate.standard_error, estimate.independent_samples, is_reached(estimate, wanted.error)});
        }
    }
    return errors;
}

}  // namespace

bool ErrorsToReach::reached(const Stage& stage, const RunAverages& averages, bool sampled, bool last,
                            RunOutputs& outputs) {
    if (stage.until.empty() || reached_) {
        return false;
    }
    const Index samples = averages.samples();
    const bool look = last || (sampled && is_look(samples));
    const bool show = sampled && samples % std::max<Index>(1, samples / shown_share) == 0;
    if (!look && !show) {
        return false;
    }
    const std::vector<ErrorSoFar> errors = errors_of(stage, averages);
    outputs.errors(errors);
    reached_ = look && std::ranges::all_of(errors, &ErrorSoFar::reached);
    return reached_;
}

/// The errors that decided the length are known less well than errors of a length that was chosen before, see
/// stopped_estimate().
void ErrorsToReach::add_to(RunResult& result, const Stage& stage, const RunAverages& averages) const {
    if (stage.until.empty()) {
        return;
    }
    result.stages.back().until = {errors_of(stage, averages), stage.steps, reached_};
    widen_wanted(result.averages, stage.until);
    if (result.at_requested) {
        widen_wanted(result.at_requested->observables, stage.until);
    }
}

void widen_wanted(std::vector<ObservableAverage>& averages, const std::vector<WantedError>& wanted) {
    for (ObservableAverage& average : averages) {
        if (average.estimate && std::ranges::find(wanted, average.name, &WantedError::observable) != wanted.end()) {
            average.estimate = stopped_estimate(*average.estimate);
        }
    }
}

}  // namespace ljmd
