#include "cli/studies/reference_phase.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/streams.hpp"
#include "cli/studies/replica_study.hpp"
#include "cli/studies/study_steps.hpp"
#include "run/run_directory.hpp"
#include "study/child_run.hpp"
#include "study/replicas.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

const fs::path& made(const fs::path& folder) {
    make_directory(folder);
    return folder;
}

Deck read(const std::string& name, const std::string& text) {
    Diagnostics diagnostics;
    auto deck = load_deck_text(name + ".toml", text, {}, false, diagnostics);
    diagnostics.throw_if_errors();
    return std::move(*deck);
}

}  // namespace

ReferencePhase::ReferencePhase(std::string name, const fs::path& out, const std::string& deck, Index first,
                               Index replicas, const ReplicaOptions& options)
    : name_(std::move(name)),
      first_(first),
      options_(options),
      lock_(made(out / name_)),
      deck_(read(name_, deck)),
      plan_(replica_plan(deck_, {}, replicas)) {
    if (const auto recorded = recorded_sweep(out / name_);
        recorded && recorded->deck == plan_.deck && recorded->points == plan_.points) {
        plan_.steps_added = recorded->steps_added;
    }
    prepare_sweep(plan_, lock_.directory(), options.force, wait_for_writing_runs);
}

void ReferencePhase::complete() {
    if (!options_.quiet) {
        print_message(fmt::format("{}: {} runs of {} steps\n", name_, plan_.replicas, steps()));
    }
    static_cast<void>(complete_replicas(plan_, lock_.directory(), deck_, options_.jobs, true));
}

void ReferencePhase::lengthen(Index steps) {
    plan_.steps_added = steps - first_;
    record_sweep(plan_, lock_.directory());
    complete();
}

ReplicaFolder ReferencePhase::folder() const {
    ReplicaFolder found{lock_.directory().path(), {}};
    for (const ChildRun& run : sweep_runs(plan_, found.merged)) {
        found.runs.push_back(run.directory);
    }
    return found;
}

}  // namespace ljmd
