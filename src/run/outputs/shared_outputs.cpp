#include "run/outputs/shared_outputs.hpp"

#include "ljmd/detail/run/interruption.hpp"

namespace ljmd {

void SharedOutputs::stage_begins(const Stage& stage) {
    if (outputs_ != nullptr) {
        outputs_->stage_begins(stage);
    }
}

void SharedOutputs::row(const ThermoRow& row) {
    if (outputs_ != nullptr) {
        outputs_->row(row);
    }
}

void SharedOutputs::errors(const std::vector<ErrorSoFar>& errors) {
    if (outputs_ != nullptr) {
        outputs_->errors(errors);
    }
}

bool SharedOutputs::frame_is_due(const State& state) const {
    return plan_.trajectory && state.step % plan_.trajectory->every == 0;
}

void SharedOutputs::frame(const State& state, const std::optional<double>& angle) {
    if (outputs_ != nullptr) {
        outputs_->frame(state, angle);
    }
}

void SharedOutputs::step_done(Index step) {
    if (outputs_ != nullptr) {
        outputs_->step_done(step);
    }
}

bool SharedOutputs::checkpoint_is_due(Index step, bool last_of_stage) {
    std::int64_t due = outputs_ != nullptr && outputs_->checkpoint_is_due(step, last_of_stage) ? 1 : 0;
    ranks_.sum({&due, 1});
    return due > 0;
}

void SharedOutputs::checkpoint(const State& state, const LoopPosition& position,
                               const std::function<void(Archive&)>& archive) {
    std::int64_t stopped_with = 0;
    if (outputs_ == nullptr) {
        Archive nowhere;
        archive(nowhere);
        ranks_.sum({&stopped_with, 1});
        if (stopped_with > 0) {
            throw Interrupted("rank 0 has stopped the run", static_cast<int>(stopped_with));
        }
        return;
    }
    try {
        outputs_->checkpoint(state, position, archive);
    } catch (const Interrupted& stop) {
        stopped_with = stop.exit_code();
        ranks_.sum({&stopped_with, 1});
        throw;
    }
    ranks_.sum({&stopped_with, 1});
}

}  // namespace ljmd
