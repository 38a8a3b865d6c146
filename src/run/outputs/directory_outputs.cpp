#include "run/outputs/directory_outputs.hpp"

namespace ljmd {

DirectoryOutputs::DirectoryOutputs(const RunPlan& plan, RunListener& listener, const RunControl& control)
    : plan_(plan),
      listener_(listener),
      control_(control),
      checkpoints_(plan, control.interruption, control.continuation, control.has_begun) {}

std::optional<LoopPosition> restored(const RunPlan& plan, const std::optional<Continuation>& continuation,
                                     RunMeasurement& measurement, const State& state) {
    if (!continuation) {
        return std::nullopt;
    }
    const LoopPosition& position = continuation->head.position;
    measurement.resume_at(position);
    continuation->restore(plan, state, [&measurement](Archive& a) { measurement.archive(a); });
    measurement.require_begun(position);
    return position;
}

bool DirectoryOutputs::checkpoint_is_due(Index step, bool last_of_stage) {
    return checkpoints_.due(step, last_of_stage);
}

void DirectoryOutputs::checkpoint(const State& state, const LoopPosition& position,
                                  const std::function<void(Archive&)>& archive) {
    const CommittedOutputs outputs = files_->commit();
    checkpoints_.write(state, position, outputs, archive);
}

}  // namespace ljmd
