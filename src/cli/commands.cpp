#include "ljmd/cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "ljmd/cli/bench.hpp"
#include "ljmd/cli/judge/judge_command.hpp"
#include "ljmd/cli/progress.hpp"
#include "ljmd/cli/ranks.hpp"
#include "ljmd/cli/signals.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/compare/compare_gsl.hpp"
#include "ljmd/compare/crosscheck_report.hpp"
#include "ljmd/compare/export.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/deck/checked_run.hpp"
#include "ljmd/deck/deck_sense.hpp"
#include "ljmd/deck/deck_system.hpp"
#include "ljmd/execution/execution.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/io/files/input_file.hpp"
#include "ljmd/io/files/shell_word.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "ljmd/report/written_report.hpp"
#include "ljmd/run/held_run.hpp"
#include "ljmd/run/output_guard.hpp"
#include "ljmd/run/recorded_run.hpp"
#include "ljmd/run/run.hpp"
#include "ljmd/run/run_directory.hpp"

namespace ljmd {

namespace {

/// The settings of a deck that its options make.
std::vector<std::string> settings_of(const DeckOptions& options) {
    // Report a wrong --simd or LJMD_SIMD before anything is done.
    static_cast<void>(default_simd_level(options.simd));
    std::vector<std::string> settings = options.settings;
    if (!options.precision.empty()) {
        settings.push_back("performance.precision=" + options.precision);
    }
    return settings;
}

/// @throws InputError with all mistakes of the deck
Deck load(const DeckOptions& options, Diagnostics& diagnostics) {
    const std::vector<std::string> settings = settings_of(options);
    if (options.deck.empty()) {
        throw InputError("the name of the deck is empty");
    }
    auto deck = load_deck(options.deck, settings, options.force, diagnostics);
    diagnostics.throw_if_errors();
    return std::move(*deck);
}

/// The deck that `ljmd bench` has for those who name none.
Deck load_melt(const DeckOptions& options, Diagnostics& diagnostics) {
    auto deck =
        load_deck_text("melt-32k.toml", std::string(melt_deck()), settings_of(options), options.force, diagnostics);
    diagnostics.throw_if_errors();
    return std::move(*deck);
}

/// The start of a deck after all checks, and the threads that the system has granted. Prints the warnings.
CheckedRun checked(const Deck& deck, const DeckOptions& options, Diagnostics& diagnostics,
                   const std::shared_ptr<Ranks>& ranks = nullptr) {
    CheckedRun run = checked_run(deck, options.threads, options.simd, diagnostics, ranks);
    if (!options.quiet) {
        print_warnings(diagnostics);
    }
    return run;
}

/// Input of `ljmd export`: a deck and its start configuration, or that of a run and its last configuration.
struct Exportable {
    Deck deck;
    State state;
};

void refuse_bodies(const Deck& deck) {
    require_fluid(deck, "a few-body deck has no box and no pair potential: `ljmd export` wants a fluid");
}

Exportable end_of_run(const DeckOptions& options, Diagnostics& diagnostics) {
    const Deck deck = recorded_deck(options.deck, options.settings, diagnostics);
    refuse_bodies(deck);
    State state = last_configuration(options.deck, deck);
    check_box(deck.fluid(), state.count(), state.box(), diagnostics);
    diagnostics.throw_if_errors();
    return {deck, std::move(state)};
}

Exportable start_of_deck(const DeckOptions& options, Diagnostics& diagnostics) {
    const Deck deck = load(options, diagnostics);
    refuse_bodies(deck);
    CheckedRun fluid = checked(deck, options, diagnostics);
    FluidSystem simulation =
        make_fluid(fluid_spec(deck, std::move(fluid.start.value())), fluid.execution, [&](const std::string& text) {
            if (!options.quiet) {
                warn(text);
            }
        });
    return {deck, std::move(simulation.state)};
}

/// "argon-lammps" for `argon.toml` or `runs/argon` and target `lammps`; in the working directory.
std::filesystem::path export_directory(const std::filesystem::path& source, bool is_run, const std::string& to) {
    const std::filesystem::path whole = files::absolute(source).lexically_normal();
    const std::filesystem::path name = !is_run                ? whole.stem()
                                       : whole.has_filename() ? whole.filename()
                                                              : whole.parent_path().filename();
    return output_name(name.string(), "-" + to);
}

std::string export_json(const Exportable& what, const Exported& written, const std::string& to) {
    std::vector<std::string> files;
    for (const std::filesystem::path& file : written.files) {
        files.push_back(file.string());
    }
    const Data json = {{"target", to},
                       {"files", files},
                       {"atoms", what.state.count()},
                       {"step", what.state.step},
                       {"stage", exported_stage(what.deck).name},
                       {"time_step", exported_stage(what.deck).time_step},
                       {"warnings", written.warnings}};
    return to_json(json) + "\n";
}

std::string export_report(const Exportable& what, const Exported& written) {
    const Stage& stage = exported_stage(what.deck);
    std::string text = fmt::format("{} atoms after {} steps; time step {} tau, of stage '{}'\n", what.state.count(),
                                   what.state.step, stage.time_step, stage.name);
    for (const std::filesystem::path& file : written.files) {
        text += fmt::format("  {}\n", file.string());
    }
    return text + written.usage + "\n";
}

void compare_bodies(const Deck& deck, const DeckOptions& options, const std::string& out) {
    Progress progress(std::nullopt, total_steps(deck.stages), options.quiet);
    const GslComparison comparison = compare_with_gsl(deck, progress);
    progress.clear_line();
    if (!out.empty()) {
        write_comparison(comparison, deck, out, options.force);
    }
    print_result(options.json ? comparison_json(comparison, deck) + "\n" : comparison_table(comparison, deck));
    if (!comparison.passed()) {
        throw PhysicsError("the reference does not conserve the energy: bodies come too close for it");
    }
}

void compare_fluid(const Deck& deck, CheckedRun fluid, const DeckOptions& options, const CrosscheckOptions& compared,
                   const std::string& out) {
    Progress progress(fluid.atoms(), steps_before_crosscheck(deck), options.quiet);
    const auto say = [&](const std::string& text) {
        if (!options.quiet) {
            progress.clear_line();
            print_message(text + "\n");
        }
    };
    FluidSystem simulation = make_fluid(fluid_spec(deck, std::move(fluid.start.value())), fluid.execution,
                                        [&](const std::string& text) { progress.warning(text); });
    const Crosscheck found = crosscheck(deck, simulation, compared, progress, say);
    progress.clear_line();
    if (!out.empty()) {
        write_crosscheck(found, deck, compared, out, options.force);
    }
    print_result(options.json ? crosscheck_json(found, deck, compared) + "\n"
                              : crosscheck_table(found, deck, compared) + (out.empty() ? "" : told_files(out)));
    if (!found.passed()) {
        throw PhysicsError(fmt::format("ljmd and {} differ: {} of {} checks failed", found.peer, found.failures(),
                                       found.checks.size()));
    }
}

/// Refuse options that would have no effect.
void check_compare_options(const CrosscheckOptions& compared) {
    const CrosscheckOptions usual{.with = compared.with};
    const bool follows = compared.steps == usual.steps && compared.frames == usual.frames;
    if (compared.platform != usual.platform && compared.with != "openmm") {
        throw InputError(fmt::format("--platform is OpenMM's: '{}' has none", compared.with));
    }
    if (compared.timeout != usual.timeout) {
        throw InputError(fmt::format("--timeout is of an engine, --with command:...: '{}' has none", compared.with));
    }
    if (compared.with == "gsl" && !(follows && compared.parts.empty())) {
        throw InputError(
            "--steps, --frames and --parts are for a fluid: few bodies are compared over the deck's steps");
    }
    if (!compared.wants("trajectory") && !follows) {
        throw InputError("--steps and --frames are those of the trajectory, which --parts leaves out");
    }
}

/// Doubts about results stand below the table, too: where both are read, there alone.
void print_doubts_once(Progress& progress, bool as_json) {
    if (!as_json && messages_stand_beside_results()) {
        progress.leave_doubts_to_report();
    }
}

/// Write the page about a finished run, if its deck asks for one, and tell where it is.
void show_asked_report(const Deck& deck) {
    if (const auto page = write_asked_report(deck, warn)) {
        print_message(fmt::format("report: {}\n", page->string()));
    }
}

}  // namespace

namespace {

class Silent : public RunListener {};

struct ReadDeck {
    Deck deck;
    CheckedRun run;
};

ReadDeck read_deck(const DeckOptions& options, const std::string& out, const std::shared_ptr<Ranks>& ranks) {
    Diagnostics diagnostics;
    Deck deck = load(options, diagnostics);
    if (!out.empty()) {
        deck.directory = out;
    }
    CheckedRun run = checked(deck, options, diagnostics, ranks);
    return {std::move(deck), std::move(run)};
}

/// The part of a rank other than rank 0, whose options have no effect on files and screen.
void run_as_member(DeckOptions options, const std::shared_ptr<Ranks>& ranks) {
    options.quiet = true;
    ignore_stop_signals();
    std::optional<ReadDeck> read;
    prepare_together(ranks, [&] { read = read_deck(options, "", ranks); });
    require_shareable(ranks, read->deck, read->run);
    Silent silent;
    AnySystem system = make_system(read->deck, std::move(read->run.start), read->run.execution, [](const auto&) {});
    run_deck(read->deck, system, silent);
}

}  // namespace

void run_command(DeckOptions options, const std::string& out, const std::string& walltime) {
    const std::shared_ptr<Ranks> ranks = shared_ranks();
    options.simd = agreed_simd(ranks, options.simd);
    if (ranks && !ranks->is_root()) {
        run_as_member(options, ranks);
        return;
    }
    RunControl control{.interruption = until_signal(wall_time(walltime))};
    std::optional<ReadDeck> read;
    prepare_together(ranks, [&] {
        read = read_deck(options, out, ranks);
        check_directory(read->deck, options.force);
    });
    auto& [deck, run] = *read;
    require_shareable(ranks, deck, run);
    Progress progress(run.atoms(), total_steps(deck.stages), options.quiet);
    AnySystem system = make_system(deck, std::move(run.start), run.execution,
                                   [&](const std::string& text) { progress.warning(text); });
    print_doubts_once(progress, options.json);
    install_stop_handlers();  // before this, nothing would be lost
    const Document results = run_in_locked_directory(deck, system, options.force, progress, control);
    progress.clear_line();
    print_document(results, options.json);
    show_asked_report(deck);
}

namespace {

void resume_as_member(const ResumeOptions& options, const std::shared_ptr<Ranks>& ranks) {
    ignore_stop_signals();
    std::optional<HeldRun> run;
    prepare_together(ranks, [] {});  // rank 0 holds the directory
    prepare_together(ranks, [&] {
        run.emplace(
            options.directory, options.more_steps, options.threads, [](const std::string&) {}, GivenAgain{}, ranks);
    });
    require_shareable(ranks, *run);
    const CheckpointHead from = run->checkpoint();
    AnySystem system = empty_system(run->deck(), from.atoms, from.edges, run->execution());
    Silent silent;
    run_deck(run->deck(), system, silent, {.continuation = run->take()});
}

}  // namespace

void resume_command(const ResumeOptions& options) {
    const std::shared_ptr<Ranks> ranks = shared_ranks();
    if (ranks && !ranks->is_root()) {
        resume_as_member(options, ranks);
        return;
    }
    RunControl control{.interruption = until_signal(wall_time(options.walltime))};
    install_stop_handlers();
    std::optional<HeldRun> held;
    prepare_together(ranks, [&] {
        held.emplace(options.directory, options.more_steps, options.threads, warn, GivenAgain{}, ranks);
    });
    prepare_together(ranks, [] {});  // the others have read the checkpoint
    HeldRun& run = *held;
    require_shareable(ranks, run);
    const CheckpointHead from = run.checkpoint();
    const Index steps = total_steps(run.deck().stages);
    AnySystem system = empty_system(run.deck(), from.atoms, from.edges, run.execution());
    Progress progress(std::holds_alternative<FluidSystem>(system) ? std::optional(from.atoms) : std::nullopt, steps,
                      options.quiet, from.step);
    print_doubts_once(progress, options.json);
    for (const std::string& warning : run.warnings()) {
        progress.warning(warning);
    }
    if (!options.quiet) {
        print_message(
            run.is_at_its_end()
                ? fmt::format("the run was finished after step {}, its results are written anew; to make it longer: "
                              "ljmd resume {} --steps +N\n",
                              from.step, shell_word(options.directory))
                : fmt::format("resuming after step {} of {}{}\n", from.step,
                              run.deck().stages.back().until.empty() ? "" : "at most ", steps));
    }
    control.continuation = run.take();
    const Document results = run_deck(run.deck(), system, progress, control);
    progress.clear_line();
    print_document(results, options.json);
    show_asked_report(run.deck());
    run.warn_if_moved();
}

void check_command(const DeckOptions& options) {
    Diagnostics diagnostics;
    const Deck deck = load(options, diagnostics);
    print_document(check_report(deck, checked(deck, options, diagnostics)), options.json);
}

void compare_command(const DeckOptions& options, const CrosscheckOptions& compared, const std::string& out) {
    if (is_engine(compared.with)) {
        check_engine_options(compared);
        Diagnostics diagnostics;
        const Deck deck = load(options, diagnostics);
        require_fluid(deck, fmt::format("{} is a few-body deck: an engine is judged by a fluid", deck.path));
        judge_engine(deck, checked(deck, options, diagnostics), options, compared, out);
        return;
    }
    static const std::vector<std::string> programs{"gsl", "lammps", "openmm"};
    if (std::find(programs.begin(), programs.end(), compared.with) == programs.end()) {
        throw InputError(fmt::format(
            "unknown program '{}' to compare with, allowed: {}, command:'./engine {{input}} {{output}}', files:DIR",
            compared.with, fmt::join(programs, ", ")));
    }
    check_compare_options(compared);
    if (!out.empty()) {
        const std::string name = "compare-" + compared.with;
        require_no_outputs(out, {name + ".json", name + ".csv", name + "-trajectory.csv", name + "-rdf.csv"},
                           options.force, "Nothing was compared");
    }
    Diagnostics diagnostics;
    const Deck deck = load(options, diagnostics);
    if (compared.with == "gsl") {
        compare_bodies(deck, options, out);
        return;
    }
    require_fluid(deck, fmt::format("{} is a few-body deck, which '{}' does not take; '--with gsl' compares it",
                                    deck.path, compared.with));
    compare_fluid(deck, checked(deck, options, diagnostics), options, compared, out);
}

void export_command(const DeckOptions& options, const std::string& to, const std::string& out, bool forces) {
    const bool is_run = input_is_directory(options.deck);
    const std::filesystem::path directory =
        out.empty() ? export_directory(options.deck, is_run, to) : std::filesystem::path(out);
    check_export(to, directory, options.force);
    Diagnostics diagnostics;
    const Exportable what = is_run ? end_of_run(options, diagnostics) : start_of_deck(options, diagnostics);
    require_no_input(what.deck, export_files(to, directory), "Nothing was written");
    const Exported written = export_configuration(what.deck, what.state, to, directory, forces, options.force);
    if (!options.quiet) {
        for (const std::string& warning : written.warnings) {
            warn(warning);
        }
    }
    print_result(options.json ? export_json(what, written, to) : export_report(what, written));
}

void bench_command(const DeckOptions& options) {
    Diagnostics diagnostics;
    Deck deck = options.deck.empty() ? load_melt(options, diagnostics) : load(options, diagnostics);
    require_fluid(deck, "a few-body deck has no speed worth measuring: `ljmd bench` wants a fluid");
    CheckedRun fluid = checked(deck, options, diagnostics);
    const BenchResult result = bench(std::move(deck), std::move(fluid.start.value()), fluid.execution);
    print_result(options.json ? bench_json(result) : bench_report(result));
}

}  // namespace ljmd
