#include "study/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "io/files/claimed_file.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/shell_word.hpp"
#include "ljmd/core/errors.hpp"
#include "run/continuation.hpp"
#include "run/recorded_run.hpp"
#include "study/child_run.hpp"
#include "study/sweep_record.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_foreign_text = 1000;  // of text that others have written
constexpr std::array<const char*, 5> states{"finished", "running", "stopped", "failed", "not begun"};

struct RunState {
    std::string name;
    fs::path directory;
    std::string state;          ///< one of `states`
    std::optional<Index> step;  ///< of the newest checkpoint
    Index total_steps = 0;      ///< of all stages; 0 if its deck cannot be read
    std::string words;          ///< from the log, if it failed
};

enum class StudyKind { sweep, replicas, reference, reproduction };

struct Study {
    StudyKind kind = StudyKind::reproduction;
    std::string deck = {};  ///< of a sweep and of replicas
    bool running = false;   ///< whether the command is running
    std::vector<RunState> runs = {};

    [[nodiscard]] auto count(const std::string& state) const {
        return std::ranges::count(runs, state, &RunState::state);
    }
};

/// Steps that decks of runs ask for. Decks of one study differ in few keys: a deck is read only if its text, or what is
/// set of its stages, is new.
class AskedSteps {
  public:
    /// @return 0 if the deck cannot be read
    Index operator()(const ChildRun& run) {
        std::string text = run.source;
        for (const std::string& setting : run.settings) {
            text += setting.find("stage") < setting.find('=') ? "\n" + setting : "";
        }
        const auto [found, is_new] = known_.try_emplace(std::move(text), 0);
        if (is_new) {
            Diagnostics diagnostics;
            const auto deck = load_deck_text(run.deck.string(), run.source, run.settings, true, diagnostics);
            found->second = deck ? total_steps(deck->stages()) : 0;
        }
        return found->second;
    }

  private:
    std::unordered_map<std::string, Index> known_;
};

/// @param name         in the report
/// @param steps_added  to those that its deck asks for
RunState state_of(const std::string& name, const ChildRun& run, Index steps_added, AskedSteps& asked_steps) {
    const fs::path& directory = run.directory;
    RunState found{name, directory, "not begun", std::nullopt, 0, ""};
    const bool running = DirectoryLock::is_held(directory) || ClaimedFile::is_held(run.log);
    const std::string words = running ? "" : recorded_failure(run.log);
    if (!files::exists(directory / "run.json")) {
        found.state = running ? "running" : words.empty() ? "not begun" : "failed";
        found.words = words;
        found.total_steps = asked_steps(run) + steps_added;
        return found;
    }
    try {
        const RecordedRun recorded = recorded_run(directory);
        if (recorded.finished) {
            found.state = "finished";
        } else if (running) {
            found.state = "running";
        } else {
            found.state = words.empty() ? "stopped" : "failed";
            found.words = words;
        }
        found.total_steps = total_steps(recorded.deck.stages());
        if (const auto continuation = find_continuation(recorded.deck)) {
            found.step = continuation->head.step;
            found.total_steps = steps_of_run(recorded, continuation->head);
        }
    } catch (const CheckpointError&) {
        found.step.reset();             // `ljmd info` for this run shows what is wrong with its checkpoints
    } catch (const DataError& error) {  // a damaged run.json
        found.state = running ? "running" : "failed";
        found.words = running ? "" : error.what();
    }
    return found;
}

Study study_in(const fs::path& directory) {
    Study study{.running = DirectoryLock::is_held(directory)};
    AskedSteps asked_steps;
    if (files::exists(directory / reference_file)) {
        study.kind = StudyKind::reference;
        for (const char* phase : reference_phases) {
            if (const auto plan = recorded_sweep(directory / phase)) {
                for (const ChildRun& run : sweep_runs(*plan, directory / phase)) {
                    study.runs.push_back(
                        state_of(fmt::format("{}/{}", phase, run.name), run, plan->steps_added, asked_steps));
                }
            }
        }
        return study;
    }
    if (const auto plan = recorded_sweep(directory)) {
        study.kind = plan->replicas > 0 ? StudyKind::replicas : StudyKind::sweep;
        study.deck = plan->deck_file;
        for (const ChildRun& run : sweep_runs(*plan, directory)) {
            study.runs.push_back(state_of(run.name, run, plan->steps_added, asked_steps));
        }
        return study;
    }
    const fs::path rows = directory / "rows";
    for (const fs::path& entry : files::list(rows)) {
        if (entry.extension() == ".toml") {
            const std::string name = entry.stem().string();
            study.runs.push_back(state_of(name,
                                          {.name = name,
                                           .deck = entry,
                                           .source = files::is_regular_file(entry) ? read_input(entry) : "",
                                           .directory = rows / name,
                                           .log = rows / (name + ".log")},
                                          0, asked_steps));
        }
    }
    std::ranges::sort(study.runs, {}, &RunState::name);
    return study;
}

std::string progress_of(const RunState& run) {
    return run.state == "finished" || !run.step
               ? run.state
               : fmt::format("{} at step {} of {}", run.state, *run.step, run.total_steps);
}

/// Name and progress of each run, behind them what its log says; where that does not fit, below.
std::string table_of(const std::vector<RunState>& runs, std::optional<std::size_t> screen) {
    const auto made = [&](bool with_words) {
        TextTable table({{"", TextTable::Align::left}, {"", TextTable::Align::left}, {"", TextTable::Align::left}}, 2);
        for (const RunState& run : runs) {
            table.add({run.name, progress_of(run), with_words ? run.words : ""});
        }
        return table;
    };
    const TextTable whole = made(true);
    if (!screen || whole.columns() <= *screen) {
        return whole.text();
    }
    std::string text = made(false).text_within(*screen);
    for (const RunState& run : runs) {
        if (!run.words.empty()) {
            text += wrapped(fmt::format("  {}: {}", run.name, run.words), *screen, 4) + '\n';
        }
    }
    return text;
}

std::string text_of(const Study& study, const fs::path& directory, std::optional<std::size_t> screen) {
    const std::string what =
        study.kind == StudyKind::replicas    ? fmt::format("{} replicas of one deck", study.runs.size())
        : study.kind == StudyKind::sweep     ? fmt::format("a sweep of {} runs", study.runs.size())
        : study.kind == StudyKind::reference ? fmt::format("a reference of {} runs", study.runs.size())
                                             : fmt::format("a reproduced table of {} runs", study.runs.size());
    std::string text = fmt::format("{}: {}{}\n", directory.string(), what, study.running ? ", under way" : "");
    if (!study.deck.empty()) {
        text += fmt::format("deck          {}\n", printable(study.deck, longest_foreign_text));
    }
    for (const char* state : states) {
        if (const auto count = study.count(state); count > 0) {
            text += fmt::format("{:<14}{}\n", state, count);
        }
    }
    text += table_of(study.runs, screen);
    const bool whole = study.count("finished") == std::ssize(study.runs);
    const std::string how = study.kind == StudyKind::replicas ? fmt::format("ljmd resume {}", shell_word(directory))
                                                              : "the command that began it";
    return text + (whole || study.running ? "" : fmt::format("to go on: {}\n", how));
}

Data data_of(const Study& study) {
    Data json = {{"kind", study.kind == StudyKind::replicas    ? "replicas"
                          : study.kind == StudyKind::sweep     ? "sweep"
                          : study.kind == StudyKind::reference ? "reference"
                                                               : "reproduction"},
                 {"running", study.running}};
    if (!study.deck.empty()) {
        json["deck"] = study.deck;
    }
    for (const char* state : states) {
        json["states"][state] = study.count(state);
    }
    json["runs"] = Data::list();
    for (const RunState& run : study.runs) {
        json["runs"].push_back({{"name", run.name},
                                {"directory", run.directory.string()},
                                {"state", run.state},
                                {"step", run.step},
                                {"total_steps", run.total_steps},
                                {"words", run.words}});
    }
    return json;
}

}  // namespace

bool holds_study(const fs::path& directory) {
    return files::exists(directory / "sweep.json") || files::exists(directory / reference_file) ||
           (input_is_directory(directory / "rows") && !files::exists(directory / "run.json"));
}

Document study_report(const fs::path& directory, std::optional<std::size_t> screen) {
    const Study study = study_in(directory);
    return {data_of(study), text_of(study, directory, screen)};
}

}  // namespace ljmd
