#include "report/run_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "report/lenient_data.hpp"
#include "report/methods.hpp"
#include "report/quantity_names.hpp"
#include "run/continuation.hpp"
#include "run/recorded_run.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// "2026-11-27 08:12 UTC" for "2026-11-27T08:12:01Z".
std::string date_in_words(const std::string& time) {
    constexpr std::size_t of_day = 10;
    constexpr std::size_t to_minute = 16;
    return time.size() < to_minute || time[of_day] != 'T'
               ? time
               : fmt::format("{} {} UTC", time.substr(0, of_day), time.substr(of_day + 1, to_minute - of_day - 1));
}

std::string seconds_in_words(double seconds) {
    constexpr double minute = 60.0;
    constexpr double hour = 3600.0;
    return seconds < minute ? fmt::format("{:.3g} s", seconds)
           : seconds < hour ? fmt::format("{:.1f} min", seconds / minute)
                            : fmt::format("{:.1f} h", seconds / hour);
}

/// "step 2000 of 5000", from the newest checkpoint.
std::string place_in_words(RunFacts& facts) {
    if (!facts.run) {
        return "";
    }
    try {
        const auto continuation = find_continuation(facts.run->deck);
        if (!continuation) {
            return "";
        }
        facts.problems.insert(facts.problems.end(), continuation->warnings.begin(), continuation->warnings.end());
        return fmt::format("step {} of {}", continuation->head.step, steps_of_run(*facts.run, continuation->head));
    } catch (const Error& error) {
        facts.problems.emplace_back(error.what());
        return "";
    }
}

void find_state(RunFacts& facts) {
    if (flag_in(facts.record, {"finished"}) == true) {
        facts.state = "finished";
        facts.state_words = fmt::format("finished on {}", date_in_words(text_in(facts.record, {"ended"})));
        if (const auto seconds = number_in(facts.record, {"seconds_in_time_loop"})) {
            facts.state_words += fmt::format(", after {} of computing", seconds_in_words(*seconds));
        }
        return;
    }
    const std::string place = place_in_words(facts);
    if (DirectoryLock::is_held(facts.directory)) {
        facts.state = "running";
        facts.state_words = place.empty() ? "running" : fmt::format("running; its last checkpoint is of {}", place);
    } else if (input_is_there(facts.directory / "failed.xyz")) {
        facts.state = "failed";
        facts.state_words = "the run has blown up; failed.xyz has the configuration at which it stopped";
    } else {
        facts.state = "stopped";
        facts.state_words = place.empty() ? "stopped before its first checkpoint"
                                          : fmt::format("stopped; its last checkpoint is of {}", place);
    }
}

void add_texts(std::vector<std::string>& list, const Data& data) {
    if (const Data* found = value_in(data, {"warnings"}); found != nullptr && found->is_list()) {
        for (const Data& each : found->items()) {
            if (each.is_text()) {
                list.push_back(each.text());
            }
        }
    }
}

TextPairs provenance_of(const RunFacts& facts) {
    TextPairs pairs;
    for (const auto& [key, label] : {std::pair{"host", "host"},
                                     {"began", "began"},
                                     {"ended", "ended"},
                                     {"seconds_in_time_loop", "seconds in the time loop"},
                                     {"resumed_at_steps", "resumed after steps"},
                                     {"threads", "threads"},
                                     {"simd", "instructions"},
                                     {"precision", "precision"},
                                     {"seed", "seed"},
                                     {"deck_file", "deck"},
                                     {"settings", "settings"},
                                     {"deck_hash", "hash of the deck"},
                                     {"given", "given by a program"}}) {
        std::string text = text_in(facts.record, {key});
        if (const auto number = number_in(facts.record, {key}); number && *number != std::floor(*number)) {
            text = fmt::format("{:.4g}", *number);  // a time of the clock
        }
        if (!text.empty() && text != "[]") {
            pairs.emplace_back(label, text);
        }
    }
    return pairs;
}

}  // namespace

bool RunFacts::is_few_body() const {
    return text_in(record, {"kind"}) == "few-body";
}

RunFacts run_facts(const fs::path& directory) {
    RunFacts facts{directory, {}, {}, {}, "", "", {}};
    const fs::path record = directory / "run.json";
    if (!input_is_there(record)) {
        throw DataError(not_a_run(directory));
    }
    facts.record = read_any_json(record);
    if (text_in(facts.record, {"program"}) != "ljmd") {
        throw DataError(fmt::format("{} is not the record of a run of ljmd", record.string()));
    }
    add_if_readable(facts.problems, [&] { facts.run = recorded_run(directory); });
    find_state(facts);
    const fs::path results = directory / "results.json";
    if (input_is_there(results)) {
        add_if_readable(facts.problems, [&] { facts.results = read_any_json(results); });
    } else if (facts.state == "finished") {
        facts.problems.push_back(fmt::format("{} is missing", results.string()));
    }
    if (!facts.problems.empty() && facts.state != "running") {
        facts.state = facts.state == "finished" ? "damaged" : facts.state;
    }
    return facts;
}

PageContent page_of(const RunFacts& facts) {
    PageContent page{.kind = facts.is_few_body() ? "few-body" : "run",
                     .title = text_in(facts.record, {"title"}),
                     .source = facts.directory.string(),
                     .state = facts.state,
                     .state_words = facts.state_words,
                     .warnings = facts.problems};
    if (page.title.empty()) {
        page.title = text_in(facts.record, {"deck_file"});
    }
    add_texts(page.warnings, facts.results);
    for (const char* key : {"program", "version", "commit", "compiler", "build_type", "flags", "simd", "precision"}) {
        if (const std::string text = text_in(facts.record, {key}); !text.empty()) {
            page.program.emplace_back(in_plain_words(key), text);
        }
    }
    page.provenance = provenance_of(facts);
    page.downloads = {{"deck", text_in(facts.record, {"deck"})},
                      {"methods", methods_paragraph(facts)},
                      {"bibtex", bibtex_of(text_in(facts.record, {"version"}))}};
    return page;
}

}  // namespace ljmd
