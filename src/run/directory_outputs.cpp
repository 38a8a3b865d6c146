#include "ljmd/run/directory_outputs.hpp"

namespace ljmd {

DirectoryOutputs::DirectoryOutputs(const Deck& deck, RunListener& listener, const RunControl& control)
    : deck_(deck),
      listener_(listener),
      control_(control),
      checkpoints_(deck, control.interruption, control.continuation, control.has_begun) {}

void DirectoryOutputs::restore(RunMeasurement& measurement, const State& state) {
    if (!control_.continuation) {
        return;
    }
    const LoopPosition& position = control_.continuation->head.position;
    measurement.resume_at(position);
    control_.continuation->restore(deck_, state, [&measurement](Archive& a) { measurement.archive(a); });
    measurement.require_begun(position);
    check_outputs(deck_, *control_.continuation);
    if (position.begun) {
        listener_.stage_begins(deck_.stages.at(position.stage));
    }
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
