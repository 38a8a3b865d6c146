#include "ljmd/run/run_checkpoints.hpp"

#include <fmt/format.h>

#include <utility>

#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/deck/deck_sense.hpp"
#include "ljmd/model/box.hpp"
#include "ljmd/run/run_record.hpp"

namespace ljmd {

namespace {

/// Calls between readings of the clock.
constexpr int calls_between_looks = 16;

/// Minimum bytes per atom in a checkpoint: three vectors of four numbers, mass, id and image.
constexpr Index bytes_per_atom = 3 * 4 * 8 + 8 + 8 + 3 * 4;

bool is_possible_box(const Deck& deck, Index atoms, const Vec3& edges) {
    try {
        Diagnostics diagnostics;
        check_box(deck.root, atoms, Box(edges), diagnostics);
        return !diagnostics.has_errors();
    } catch (const ContractViolation&) {  // no box has these edges
        return false;
    }
}

/// Why no run of the deck can have written this checkpoint; empty if one can.
std::string impossible(const CheckpointHead& head, const Deck& deck, std::size_t bytes) {
    const LoopPosition& position = head.position;
    if (position.stage >= deck.stages.size()) {
        return "is in a stage that the deck does not have";
    }
    if (position.steps < 0 || position.steps > deck.stages[position.stage].steps ||
        (!position.begun && position.steps > 0) ||
        head.step != steps_before(deck.stages, position.stage) + position.steps) {
        return "is at a step that the deck does not have";
    }
    if (head.atoms < 1 || head.atoms > static_cast<Index>(bytes) / bytes_per_atom) {
        return "has fewer atoms than it says";
    }
    if (deck.kind == DeckKind::fluid && !is_possible_box(deck, head.atoms, head.edges)) {
        return "has a box that the deck cannot have";
    }
    if (head.outputs.thermo < 0 || head.outputs.trajectory.bytes < 0 || head.outputs.trajectory.frames < 0) {
        return "has outputs of less than nothing";
    }
    return {};
}

}  // namespace

void CheckpointHead::archive(Archive& a) {
    a.mark("ljmd run");
    a(deck_hash, version, step, atoms, edges, position, outputs);
}

std::optional<ResumePoint> find_resume_point(const Deck& deck) {
    FoundCheckpoints found = find_checkpoints(deck.directory);
    if (deck.locked) {
        deck.locked->require_at_its_path();  // else these are checkpoints of another directory
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
    ResumePoint point;
    point.file = std::move(found.whole.front());
    const std::string name = point.file.path.string();
    try {
        Archive(point.file.content)(point.head);
    } catch (const CheckpointError& why) {
        throw CheckpointError(fmt::format("{}: {}", name, why.what()));
    }
    if (point.head.version != build_info().version) {
        throw CheckpointError(
            fmt::format("{} was written by ljmd {}; this is {}", name, point.head.version, build_info().version));
    }
    if (point.head.deck_hash != deck_hash(deck)) {
        throw CheckpointError(
            fmt::format("{} belongs to another deck than {} shows", name, (deck.directory / "run.json").string()));
    }
    if (const std::string why = impossible(point.head, deck, point.file.content.size()); !why.empty()) {
        throw CheckpointError(fmt::format("{} {}", name, why));
    }
    for (const std::string& line : found.damaged) {
        point.warnings.push_back(fmt::format("{}; going on from {}", line, name));
    }
    return point;
}

void ResumePoint::restore(const Deck& deck, const State& state, const std::function<void(Archive&)>& archive) const {
    Archive a(file.content);
    CheckpointHead known;
    a(known);
    try {
        archive(a);
        a.expect_end();
        const double time_step = deck.stages.at(head.position.stage).time_step;
        const double time = head.position.first_time + static_cast<double>(head.position.steps) * time_step;
        if (state.step != head.step || state.time != time) {
            throw CheckpointError("its state is one of another time");
        }
    } catch (const CheckpointError& why) {
        throw CheckpointError(fmt::format("{}: {}", file.path.string(), why.what()));
    }
}

RunCheckpoints::RunCheckpoints(const Deck& deck, const Interruption& interruption, std::uint64_t generation,
                               std::function<void()> has_begun)
    : deck_(deck),
      store_(deck.outputs(), deck.checkpoint.keep),
      interruption_(interruption),
      has_begun_(std::move(has_begun)) {
    store_.continue_after(generation);
}

bool RunCheckpoints::due(Index step, bool last_of_stage) {
    if (last_of_stage || interruption_.request() ||
        (deck_.checkpoint.every.steps && step % *deck_.checkpoint.every.steps == 0)) {
        return true;
    }
    if (++calls_ < calls_between_looks) {
        return false;
    }
    calls_ = 0;
    const bool old = deck_.checkpoint.every.seconds &&
                     std::chrono::duration<double>(Clock::now() - last_).count() >= *deck_.checkpoint.every.seconds;
    return old || interruption_.wanted();
}

void RunCheckpoints::write(const State& state, const LoopPosition& position, const CommittedOutputs& outputs,
                           const std::function<void(Archive&)>& archive) {
    Archive a;
    constexpr Index default_bytes_per_atom = 200;
    a.reserve(static_cast<std::size_t>(default_bytes_per_atom * state.count()));
    const Vec3 edges = state.has_box() ? state.box().edges() : Vec3::Zero();
    CheckpointHead head{deck_hash(deck_), build_info().version, state.step, state.count(), edges, position, outputs};
    a(head);
    archive(a);
    store_.write(a.bytes());
    last_ = Clock::now();
    if (has_begun_) {
        std::exchange(has_begun_, nullptr)();
    }
    if (interruption_.wanted()) {
        interruption_.stop(state.step, deck_.directory.string());
    }
}

}  // namespace ljmd
