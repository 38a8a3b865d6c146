#pragma once

#include <vector>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/detail/observables/statistics/run_averages.hpp"
#include "ljmd/engine/run_result.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// The errors at which a stage with `until` ends, looked at when is_look() says so.
class ErrorsToReach {
  public:
    /// Whether the stage may end now. Asked after every step.
    /// @param sampled  there was a sample at this step
    /// @param last     it is the last step that the stage may take: its number was chosen before, so it is looked at
    /// @param outputs  are told of the errors now and then
    [[nodiscard]] bool reached(const Stage& stage, const RunAverages& averages, bool sampled, bool last,
                               RunOutputs& outputs);

    /// Write what was reached into the results of the last stage, and widen the errors that were wanted, see
    /// widen_wanted(). @pre the result has all stages
    void add_to(RunResult& result, const Stage& stage, const RunAverages& averages) const;

    void archive(Archive& a) { a(reached_); }

  private:
    bool reached_ = false;
};

/// The averages of a run that `until` has ended: those whose errors were wanted have the error of stopped_estimate().
void widen_wanted(std::vector<ObservableAverage>& averages, const std::vector<WantedError>& wanted);

}  // namespace ljmd
