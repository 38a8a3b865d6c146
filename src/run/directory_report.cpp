#include "run/directory_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "deck/deck_system.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "ljmd/core/errors.hpp"
#include "run/continuation.hpp"
#include "run/given/given_record.hpp"
#include "run/recorded_run.hpp"
#include "run/run_report.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_words = 1000;  // of text that others have written

struct Contents {
    bool running;
    RecordedRun run;
    std::optional<Continuation> continuation;
    std::vector<std::string> damaged;
    std::vector<std::pair<std::string, std::uintmax_t>> files;  ///< names and bytes, sorted by name

    /// Whether the last stage may end before its last step.
    [[nodiscard]] bool length_is_open() const {
        return !run.finished && !run.earlier.last_stage_steps && !run.deck.stages().back().until.empty() &&
               !(continuation && continuation->head.position.enough);
    }

    [[nodiscard]] Index steps() const {
        return continuation ? steps_of_run(run, continuation->head) : total_steps(run.deck.stages());
    }
    [[nodiscard]] Index steps_of_stage() const {
        const LoopPosition& position = continuation->head.position;
        return position.enough && !run.earlier.last_stage_steps ? position.steps : stage().steps;
    }

    /// The stage that the checkpoint is in.
    [[nodiscard]] const Stage& stage() const { return run.deck.stages().at(continuation->head.position.stage); }
};

Contents contents_of(const fs::path& directory) {
    Contents contents{DirectoryLock::is_held(directory), recorded_run(directory), std::nullopt, {}, {}};
    try {
        contents.continuation = find_continuation(contents.run.deck);
        contents.damaged = contents.continuation ? contents.continuation->warnings : std::vector<std::string>{};
    } catch (const CheckpointError& error) {
        contents.damaged = {error.what()};
    }
    const auto& potential = contents.run.deck.given.potential;
    if (potential && potential->bad_table) {
        contents.damaged.push_back(potential->missing);
    }
    for (const fs::path& entry : files::list(directory)) {
        if (const auto bytes = files::size_of(entry)) {
            contents.files.emplace_back(entry.filename().string(), *bytes);
        }
    }
    return contents;
}

std::string size_in_words(std::uintmax_t bytes) {
    constexpr std::uintmax_t thousand = 1000;
    if (bytes < thousand) {
        return fmt::format("{} bytes", bytes);
    }
    const double kilobytes = static_cast<double>(bytes) / static_cast<double>(thousand);
    return kilobytes < static_cast<double>(thousand)
               ? fmt::format("{:.1f} kB", kilobytes)
               : fmt::format("{:.1f} MB", kilobytes / static_cast<double>(thousand));
}

std::string text_of(const Contents& contents, const fs::path& directory) {
    const Deck& deck = contents.run.deck;
    std::string text = fmt::format("{}: {}\n", directory.string(), title_line(deck));
    text += fmt::format("deck          {}\nbegan         {}\n", printable(deck.path, longest_words),
                        printable(contents.run.earlier.began, longest_words));
    if (!contents.run.earlier.resumed_at_steps.empty()) {
        text += fmt::format("resumed       after steps {}\n", fmt::join(contents.run.earlier.resumed_at_steps, ", "));
    }
    if (!deck.given.empty()) {
        text += fmt::format("run with      {}, of a program in {}\n", in_words(deck.given),
                            printable(deck.given.by, longest_words));
    }
    text += fmt::format("finished      {}\n", contents.run.finished ? "yes"
                                              : contents.running    ? "no, it is running"
                                                                    : "no");
    if (contents.continuation) {
        const CheckpointHead& head = contents.continuation->head;
        const std::string most = contents.length_is_open() ? "at most " : "";
        text += fmt::format("checkpoint    after step {} of {}{}, {} of {}{} in stage {}\n", head.step, most,
                            contents.steps(), head.position.begun ? head.position.steps : 0,
                            contents.stage().until.empty() ? "" : most, contents.steps_of_stage(),
                            in_quotes(contents.stage().name));
    } else {
        text += "checkpoint    none\n";
    }
    for (const std::string& line : contents.damaged) {
        text += fmt::format("damaged       {}\n", printable(line, longest_words));
    }
    TextTable files({{"", TextTable::Align::left, 18}, {"", TextTable::Align::right, 10}}, 2);
    for (const auto& [name, bytes] : contents.files) {
        files.add({name, size_in_words(bytes)});
    }
    text += files.text();
    if (contents.continuation && !contents.running) {
        const std::string how = how_to_resume(deck.given, directory);
        text += !contents.run.finished ? fmt::format("to go on: {}\n", how)
                : deck.given.empty()   ? fmt::format("longer: {} --steps +N\n", how)
                                       : fmt::format("longer: {}, with more steps\n", how);
    }
    return text;
}

Data data_of(const Contents& contents) {
    const Deck& deck = contents.run.deck;
    Data checkpoint = nullptr;
    if (contents.continuation) {
        const CheckpointHead& head = contents.continuation->head;
        checkpoint = {{"step", head.step}, {"stage", contents.stage().name}, {"atoms", head.atoms}};
    }
    Data files = Data::list();
    for (const auto& [name, bytes] : contents.files) {
        files.push_back({{"name", name}, {"bytes", bytes}});
    }
    return {{"deck", deck.path},
            {"title", deck.title},
            {"kind", kind_name(deck)},
            {"finished", contents.run.finished},
            {"running", contents.running},
            {"began", contents.run.earlier.began},
            {"resumed_at_steps", contents.run.earlier.resumed_at_steps},
            {"total_steps", contents.steps()},
            {"total_steps_are_most", contents.length_is_open()},
            {"checkpoint", checkpoint},
            {"given", given_data(deck.given)},
            {"damaged", contents.damaged},
            {"files", files}};
}

}  // namespace

Document directory_report(const fs::path& directory) {
    const Contents contents = contents_of(directory);
    return {data_of(contents), text_of(contents, directory)};
}

}  // namespace ljmd
