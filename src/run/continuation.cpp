#include "run/continuation.hpp"

#include <fmt/format.h>

#include <utility>

#include "deck/deck_system.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_record.hpp"

namespace ljmd {

namespace {

/// Minimum bytes per atom in a checkpoint: three vectors of four numbers, mass, id and image.
constexpr Index bytes_per_atom = 3 * 4 * 8 + 8 + 8 + 3 * 4;

/// Why no run of the deck can have written this checkpoint; empty if one can.
std::string impossible(const CheckpointHead& head, const RunPlan& plan, std::uint64_t bytes) {
    const LoopPosition& position = head.position;
    if (position.stage >= plan.stages().size()) {
        return "is in a stage that the deck does not have";
    }
    if (position.steps < 0 || position.steps > plan.stages()[position.stage].steps ||
        (!position.begun && position.steps > 0) ||
        head.step != steps_before(plan.stages(), position.stage) + position.steps) {
        return "is at a step that the deck does not have";
    }
    if (head.atoms < 1 || head.atoms > static_cast<Index>(bytes) / bytes_per_atom) {
        return "has fewer atoms than it says";
    }
    if (!is_possible_box(plan, head.atoms, head.edges)) {
        return "has a box that the deck cannot have";
    }
    if (head.outputs.thermo < 0 || head.outputs.trajectory.bytes < 0 || head.outputs.trajectory.frames < 0) {
        return "has outputs of negative length";
    }
    return {};
}

}  // namespace

void CheckpointHead::archive(Archive& a) {
    a.mark("ljmd run");
    a(deck_hash, version, step, atoms, edges, position, outputs);
}

std::optional<Continuation> find_continuation(const RunPlan& plan, EarlierParts earlier) {
    FoundCheckpoints found = find_checkpoints(plan.directory);
    if (plan.locked) {
        plan.locked->require_at_its_path();  // else these are checkpoints of another directory
    }
    if (found.whole.empty()) {
        if (found.damaged.empty()) {
            return std::nullopt;
        }
        std::string text = "no checkpoint can be used";
        for (const std::string& line : found.damaged) {
            text += "\n  " + line;
        }
        throw CheckpointError(text);
    }
    Continuation continuation{.file = {}, .head = {}, .earlier = std::move(earlier), .warnings = {}};
    continuation.file = std::move(found.whole.front());
    const std::string name = continuation.file.path.string();
    try {
        Archive content = continuation.file.content();
        content(continuation.head);
    } catch (const CheckpointError& why) {
        throw CheckpointError(fmt::format("{}: {}", name, why.what()));
    }
    if (continuation.head.version != build_info().version) {
        throw CheckpointError(fmt::format("{} was written by ljmd {}; this is {}", name, continuation.head.version,
                                          build_info().version));
    }
    if (continuation.head.deck_hash != deck_hash(plan)) {
        throw CheckpointError(
            fmt::format("{} belongs to another deck than {} shows", name, (plan.directory / "run.json").string()));
    }
    if (const std::string why = impossible(continuation.head, plan, continuation.file.length); !why.empty()) {
        throw CheckpointError(fmt::format("{} {}", name, why));
    }
    for (const std::string& line : found.damaged) {
        continuation.warnings.push_back(fmt::format("{}; resuming from {}", line, name));
    }
    continuation.earlier.resumed_at_steps.push_back(continuation.head.step);
    return continuation;
}

void Continuation::restore(const RunPlan& plan, const State& state,
                           const std::function<void(Archive&)>& archive) const {
    Archive a = file.content();
    CheckpointHead known;
    a(known);
    try {
        archive(a);
        a.expect_end();
        const double time_step = plan.stages().at(head.position.stage).time_step;
        const double time = head.position.first_time + static_cast<double>(head.position.steps) * time_step;
        if (state.step != head.step || state.time != time) {
            throw CheckpointError("its state is at another step or time");
        }
    } catch (const CheckpointError& why) {
        throw CheckpointError(fmt::format("{}: {}", file.path.string(), why.what()));
    }
}

}  // namespace ljmd
