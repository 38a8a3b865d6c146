#pragma once

#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "deck/deck_execution.hpp"
#include "deck/deck_fixtures.hpp"
#include "run/recorded_run.hpp"
#include "run/run.hpp"
#include "run/run_directory.hpp"

namespace ljmd::test {

/// Writes down what happens in a run.
struct Recorder : RunListener {
    void stage_begins(const Stage& stage) override { stages.push_back(stage.name); }
    void step_done(Index step) override {
        steps.push_back(step);
        if (at_step) {
            at_step(step);
        }
    }
    void warning(const std::string& text) override { warnings.push_back(text); }

    std::vector<std::string> stages;
    std::vector<Index> steps;
    std::vector<std::string> warnings;
    std::function<void(Index)> at_step;
};

/// What ends a run between writing and the next checkpoint, as a kill would.
struct Killed {};

/// The system of a deck of either kind at its start, made without a warning.
inline AnySystem start_of(const Deck& deck, const Execution& execution) {
    const bool fluid = kind_name(deck) == "fluid";
    return make_system(deck, fluid ? std::optional(find_start(deck)) : std::nullopt, execution, no_warnings);
}

/// Run a deck of either kind, from its start or from a checkpoint. @param threads  0: as OMP_NUM_THREADS says
inline void run_in(const Deck& deck, RunListener& listener, const RunControl& control = {}, int threads = 0) {
    const Execution execution(execution_options(deck, threads));
    AnySystem system = control.continuation ? empty_system(deck, control.continuation->head.atoms,
                                                           control.continuation->head.edges, execution)
                                            : start_of(deck, execution);
    static_cast<void>(run_plan(deck, system, listener, control));
}

/// Run the deck and stop it dead in the step after this one. @param threads  0: as OMP_NUM_THREADS says
inline void run_until(const Deck& deck, Index step, int threads = 0) {
    prepare_directory(deck.directory);
    Recorder listener;
    listener.at_step = [&](Index now) {
        if (now > step) {
            throw Killed();
        }
    };
    try {
        run_in(deck, listener, {}, threads);
    } catch (const Killed&) {
    }
}

/// Resume the run in a directory. @param threads  0: as OMP_NUM_THREADS says
/// @return the step from which it was resumed
inline Index resume(const std::filesystem::path& directory, int threads = 0) {
    const RecordedRun run = recorded_run(directory);
    RunControl control{.continuation = find_continuation(run.deck, run.earlier)};
    REQUIRE(control.continuation.has_value());
    Recorder listener;
    run_in(run.deck, listener, control, threads);
    return control.continuation->head.step;
}

/// The header of a CSV file.
inline std::string header(const std::string& csv) {
    return csv.substr(0, csv.find('\n'));
}

/// Rows of a CSV file behind its header, fields as text.
inline std::vector<std::vector<std::string>> rows(const std::string& csv) {
    std::vector<std::vector<std::string>> all;
    std::istringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        all.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) {
            all.back().push_back(field);
        }
    }
    all.erase(all.begin());
    return all;
}

/// One column of a CSV file as numbers.
inline std::vector<double> column(const std::string& csv, const std::string& name) {
    std::istringstream names(header(csv));
    std::size_t at = 0;
    std::string found;
    while (std::getline(names, found, ',') && found != name) {
        ++at;
    }
    INFO(name << " in " << header(csv));
    REQUIRE(found == name);
    std::vector<double> numbers;
    for (const auto& row : rows(csv)) {
        numbers.push_back(std::stod(row.at(at)));
    }
    return numbers;
}

}  // namespace ljmd::test
