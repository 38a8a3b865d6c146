#include "run/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "deck/deck_system.hpp"
#include "deck/fluid.hpp"
#include "execution/threads.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/files/shell_word.hpp"
#include "io/formats/configuration_reader.hpp"
#include "io/tables/json_file.hpp"
#include "ljmd/core/errors.hpp"
#include "run/given/given_record.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

struct Record {
    std::string kind;
    std::string deck_file;
    std::string deck;
    std::vector<std::string> settings;
    EarlierParts earlier;
    std::string simd;
    int threads;
    bool finished;
    GivenParts given;
};

/// What a directory holds that is no run; empty if that is nothing of ljmd.
std::string what_else(const fs::path& directory) {
    const std::string name = directory.string();
    const std::string word = shell_word(directory);
    if (files::is_taken(directory / "reference.json")) {
        return fmt::format(
            "it holds a reference, which `ljmd reference` with the same options and --out {0} resumes and `ljmd report "
            "{0}` shows; its runs are in {1}/*/points",
            word, name);
    }
    if (files::is_taken(directory / "sweep.json")) {
        return fmt::format(
            "it holds a sweep, which the same `ljmd sweep` command resumes, or replicas, which `ljmd resume {0}` "
            "resumes; `ljmd report {0}` shows it; its runs are in {1}/points",
            word, name);
    }
    std::vector<fs::path> entries;
    if (input_is_directory(directory)) {
        entries = files::list(directory);
    }
    const bool compares = std::ranges::any_of(entries, [](const fs::path& entry) {
        const std::string file = entry.filename().string();
        return file == "judge.json" || (file.starts_with("compare-") && file.ends_with(".json"));
    });
    return compares
               ? fmt::format(
                     "it holds a comparison, which `ljmd compare --out {0}` has made and `ljmd report {0}` shows", word)
               : "";
}

Record read_record(const fs::path& path) {
    if (!input_is_there(path)) {
        throw DataError(not_a_run(path.parent_path()));
    }
    return read_json(path, "the record of a run", [&path](const Data& record) -> Record {
        if (record.at("program") != "ljmd") {
            throw WrongData("it is that of another program");
        }
        EarlierParts earlier{
            record.at("began").text(), {}, integer_of(record.at("steps_added"), "steps_added", 0, max_steps)};
        if (const Data* steps = record.find("last_stage_steps"); steps != nullptr && !steps->is_null()) {
            earlier.last_stage_steps = integer_of(*steps, "last_stage_steps", 0, max_steps);
        }
        for (const Data& step : record.at("resumed_at_steps").items()) {
            earlier.resumed_at_steps.push_back(integer_of(step, "resumed_at_steps", 0, max_steps));
        }
        const Data* given = record.find("given");  // that older records do not have
        return {record.at("kind").text(),
                record.at("deck_file").text(),
                record.at("deck").text(),
                texts_of(record.at("settings"), "settings", max_settings),
                std::move(earlier),
                record.at("simd").is_null() ? "" : record.at("simd").text(),
                static_cast<int>(integer_of(record.at("threads"), "threads", 1, max_threads)),
                record.at("finished").flag(),
                given != nullptr ? given_parts(*given, path.parent_path()) : GivenParts()};
    });
}

std::optional<Deck> loaded_deck(const Record& record, const fs::path& directory, Diagnostics& diagnostics) {
    return load_deck_text(fmt::format("deck of {}", directory.string()), record.deck, record.settings, true,
                          diagnostics, record.given);
}

/// @throws DataError  this version refuses the deck, which another one has written, or somebody has changed it or the
/// word that says of what kind it is
Deck accepted_deck(const Record& record, const fs::path& directory) {
    Diagnostics diagnostics;
    std::optional<Deck> deck = loaded_deck(record, directory, diagnostics);
    if (!deck) {
        throw DataError(fmt::format("{} holds a deck that this version of ljmd refuses: {}",
                                    (directory / "run.json").string(), diagnostics.errors_without_places()));
    }
    if (record.kind != kind_name(*deck)) {
        throw DataError(fmt::format("{}: 'kind' is {}, but its deck is one of kind '{}'",
                                    (directory / "run.json").string(), in_quotes(record.kind), kind_name(*deck)));
    }
    return std::move(*deck);
}

}  // namespace

std::string not_a_run(const fs::path& directory) {
    const std::string other = what_else(directory);
    return fmt::format("{} is not the directory of a run: it has no run.json{}{}", directory.string(),
                       other.empty() ? "" : "; ", other);
}

Deck recorded_deck(const fs::path& directory, const std::vector<std::string>& settings, Diagnostics& diagnostics) {
    Record record = read_record(directory / "run.json");
    static_cast<void>(accepted_deck(record, directory));  // mistakes of the settings are the caller's, others are not
    for (const std::string& setting : settings) {
        if (setting.starts_with("system.")) {
            throw InputError(
                fmt::format("--set {}: [system] describes the start of a run, and this run has begun", setting));
        }
        record.settings.push_back(setting);
    }
    auto deck = loaded_deck(record, directory, diagnostics);
    diagnostics.throw_if_errors();
    return std::move(*deck);
}

RecordedRun recorded_run(const fs::path& directory, Index more_steps) {
    Record record = read_record(directory / "run.json");
    Deck deck = accepted_deck(record, directory);
    deck.path = record.deck_file;
    deck.directory = directory;
    const Index room = max_steps - total_steps(deck.stages()) - record.earlier.steps_added;
    if (more_steps > room) {
        throw InputError(
            fmt::format("{} steps more are too many, at most {} can be added", more_steps, std::max<Index>(0, room)));
    }
    record.earlier.steps_added += more_steps;
    Stage& last = deck.stages().back();
    if (auto& steps = record.earlier.last_stage_steps) {
        *steps = std::min(*steps + more_steps, max_steps);
        last.steps = *steps;
    } else {
        last.steps += record.earlier.steps_added;
    }
    return {std::move(deck), record.earlier, record.simd, record.threads, record.finished};
}

void continue_past_errors(RecordedRun& run, Continuation& continuation, Index more_steps) {
    LoopPosition& position = continuation.head.position;
    if (!position.enough) {
        return;
    }
    // Steps may have been added by a run that was killed before its first checkpoint.
    if (!run.earlier.last_stage_steps) {
        if (more_steps == 0) {
            return;
        }
        Stage& last = run.deck.stages().back();
        last.steps = position.steps + more_steps;
        run.earlier.last_stage_steps = last.steps;
        continuation.earlier.last_stage_steps = last.steps;
    }
    position.enough = false;
}

Index steps_of_run(const RecordedRun& run, const CheckpointHead& head) {
    return head.position.enough && !run.earlier.last_stage_steps ? head.step : total_steps(run.deck.stages());
}

State last_configuration(const fs::path& directory, const Deck& deck) {
    const fs::path path = directory / "final.xyz";
    if (!input_is_there(path)) {
        throw DataError(fmt::format("{} has no final.xyz: the run has not come to its end", directory.string()));
    }
    const Configuration configuration = read_configuration(path, deck.units());
    if (!configuration.step || !configuration.time) {
        throw DataError(
            fmt::format("{} has no step or no time: it is not the file that ljmd wrote there", path.string()));
    }
    State state(static_cast<Index>(configuration.positions.size()), Box(configuration.edges));
    place_configuration(state, configuration);
    state.step = *configuration.step;
    state.time = *configuration.time;
    return state;
}

}  // namespace ljmd
