#include "run/run_checkpoints.hpp"

#include <utility>

#include "ljmd/core/build_info.hpp"
#include "run/run_record.hpp"

namespace ljmd {

namespace {

/// Calls between readings of the clock.
constexpr int calls_between_looks = 16;

}  // namespace

RunCheckpoints::RunCheckpoints(const RunPlan& plan, const Interruption& interruption,
                               const std::optional<Continuation>& continuation, std::function<void()> has_begun)
    : plan_(plan),
      store_(plan.outputs(), static_cast<int>(plan.checkpoint.keep)),
      interruption_(interruption),
      has_begun_(std::move(has_begun)) {
    store_.continue_after(continuation ? continuation->file.generation : 0);
}

bool RunCheckpoints::due(Index step, bool last_of_stage) {
    if (last_of_stage || interruption_.request() ||
        (plan_.checkpoint.every.steps && step % *plan_.checkpoint.every.steps == 0)) {
        return true;
    }
    if (++calls_ < calls_between_looks) {
        return false;
    }
    calls_ = 0;
    const bool old = plan_.checkpoint.every.seconds &&
                     std::chrono::duration<double>(Clock::now() - last_).count() >= *plan_.checkpoint.every.seconds;
    return old || interruption_.wanted();
}

void RunCheckpoints::write(const State& state, const LoopPosition& position, const CommittedOutputs& outputs,
                           const std::function<void(Archive&)>& archive) {
    const Vec3 edges = state.has_box() ? state.box().edges() : Vec3::Zero();
    CheckpointHead head{deck_hash(plan_), build_info().version, state.step, state.total(), edges, position, outputs};
    store_.write([&](Archive& a) {
        a(head);
        archive(a);
    });
    last_ = Clock::now();
    if (has_begun_) {
        std::exchange(has_begun_, nullptr)();
    }
    if (interruption_.wanted()) {
        interruption_.stop(state.step, plan_.directory.string());
    }
}

}  // namespace ljmd
