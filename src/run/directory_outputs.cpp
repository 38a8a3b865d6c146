#include "ljmd/run/directory_outputs.hpp"

namespace ljmd {

DirectoryOutputs::DirectoryOutputs(const Deck& deck, RunListener& listener, const RunControl& control)
    : deck_(deck),
      listener_(listener),
      control_(control),
      checkpoints_(deck, control.interruption, control.resumed ? control.resumed->point.file.generation : 0,
                   control.has_begun) {}

std::optional<ResumedOutputs> DirectoryOutputs::restore(RunMeasurement& measurement, const State& state) {
    if (!control_.resumed) {
        return std::nullopt;
    }
    const ResumePoint& point = control_.resumed->point;
    from_ = point.head.position;
    measurement.resume_at(*from_);
    point.restore(deck_, state, [&measurement](Archive& a) { measurement.archive(a); });
    measurement.require_begun(*from_);
    ResumedOutputs outputs{point.head.outputs, control_.resumed->earlier};
    check_outputs(deck_, outputs);
    if (from_->begun) {
        listener_.stage_begins(deck_.stages.at(from_->stage));
    }
    return outputs;
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
