#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <sstream>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/described_commands.hpp"
#include "ljmd/cli/evaluate/evaluate_options.hpp"
#include "ljmd/cli/exit_code.hpp"
#include "ljmd/cli/own_commands.hpp"
#include "ljmd/cli/ranks.hpp"
#include "ljmd/cli/signals.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/cli/studies/reference_options.hpp"
#include "ljmd/cli/studies/replicas_command.hpp"
#include "ljmd/cli/studies/reproduce_options.hpp"
#include "ljmd/cli/studies/sweep_options.hpp"
#include "ljmd/compare/export.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/execution/launched_ranks.hpp"
#include "ljmd/execution/threads.hpp"
#include "ljmd/input/reduced_number.hpp"
#include "ljmd/io/hdf5/hdf5_exit.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/options/registry.hpp"
#include "ljmd/study/replicas.hpp"

namespace {

constexpr int max_steps_compared = 1'000'000;

/// Check of options that take a number in reduced units: says what to write instead of "120 K".
CLI::Validator reduced(const std::string& unit, ljmd::Dimension dimension) {
    return {[=](const std::string& text) { return ljmd::not_reduced(text, unit, dimension); }, ""};
}

/// The same of an option that also takes a range or a list, whose numbers are checked where they are read.
CLI::Validator each_reduced(const std::string& unit, ljmd::Dimension dimension) {
    return {[=](const std::string& text) {
                const bool several = text.find_first_of(":|") != std::string::npos;
                return several ? std::string() : ljmd::not_reduced(text, unit, dimension);
            },
            ""};
}

void add_deck_options(CLI::App& command, ljmd::DeckOptions& options, bool deck_is_required = true) {
    command.add_option("deck", options.deck, "deck (TOML); all keys: ljmd info --keys")
        ->required(deck_is_required)
        ->type_name("DECK");
    command.add_option("--set", options.settings, "replace a value of the deck, e.g. --set system.density=0.8")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_flag("--force", options.force, "accept unlikely values; replace an earlier run");
    command.add_flag("--quiet", options.quiet, "no progress, no warnings about the deck");
    command.add_flag("--json", options.json, "print the result as JSON");
    command
        .add_option("--threads", options.threads,
                    "threads to share the work, 1 or OMP_NUM_THREADS by default; no result depends on it")
        ->type_name("N")
        ->check(CLI::Range(1, ljmd::max_threads));
    command.add_option("--precision", options.precision, "double or mixed, instead of the deck's")->type_name("P");
    command.add_option("--simd", options.simd, "instruction set of the kernels, one that `ljmd info` lists")
        ->type_name("LEVEL");
}

void add_compare_options(CLI::App& command, ljmd::CrosscheckOptions& compared) {
    command
        .add_option(
            "--with", compared.with,
            "a fluid: openmm, lammps, any engine by command:'./engine {input} {output}', or the files of one by "
            "files:DIR; few bodies: gsl, adaptive Runge-Kutta of order 8")
        ->required()
        ->type_name("PROGRAM");
    command.add_option("--platform", compared.platform, "of OpenMM: Reference, CPU, OpenCL; Reference by default")
        ->type_name("PLATFORM");
    command.add_option("--steps", compared.steps, "length of the trajectories, 1000 by default")
        ->type_name("N")
        ->check(CLI::Range(0, max_steps_compared));
    command
        .add_option("--frames", compared.frames,
                    "steps at which trajectories are judged, 1,10,100,200,500,1000 by default")
        ->type_name("N,...")
        ->delimiter(',')
        ->check(CLI::Range(1, max_steps_compared));
    command.add_option("--parts", compared.parts, "what to compare of point,trajectory,averages,speed; all by default")
        ->type_name("PART,...")
        ->delimiter(',')
        ->check(CLI::IsMember(ljmd::crosscheck_parts()));
    command
        .add_option("--timeout", compared.timeout,
                    "wall time after which an engine is stopped, as in 90s, 30min or 2h; 1h by default")
        ->type_name("TIME");
}

/// Options of replicas.
struct Several {
    ljmd::Index replicas = 0;  ///< 0: one run
    int jobs = 0;
};

/// @return that which makes several runs of one
CLI::Option* add_replica_options(CLI::App& command, Several& several) {
    CLI::Option* replicas =
        command
            .add_option(
                "--replicas", several.replicas,
                "as many independent runs, each with a seed and a directory of its own, and their merged results")
            ->type_name("N")
            ->check(CLI::Range(ljmd::Index{1}, ljmd::max_replicas));
    command.add_option("--jobs", several.jobs, "replicas at a time; one for each processor by default")
        ->type_name("N")
        ->check(CLI::Range(1, ljmd::max_threads))
        ->needs(replicas);
    replicas->excludes(command.get_option("--threads"))->excludes(command.get_option("--simd"));
    return replicas;
}

void add_analyze_options(CLI::App& command, ljmd::AnalyzeOptions& options) {
    command.add_option("path", options.path, "directory of a run; or a trajectory: H5MD, extended XYZ, LAMMPS dump")
        ->required()
        ->type_name("RUNDIR|TRAJECTORY");
    command
        .add_option("analysis", options.names,
                    fmt::format("{}, thermo; by default thermo of a run, rdf, structure_factor and msd of a trajectory",
                                fmt::join(ljmd::plugin_names(ljmd::all_analyses()), ", ")))
        ->type_name("ANALYSIS");
    command
        .add_option("--deck", options.deck,
                    "of a trajectory: interaction, [analysis], and [argon] for files in SI units")
        ->type_name("DECK");
    command.add_option("--from", options.from, "leave out what is before this time, in tau")
        ->type_name("T")
        ->check(reduced("tau", ljmd::Dimension::time));
    command
        .add_option("--time-step", options.time_step,
                    "time between steps in tau, for trajectories that do not tell; that of the deck by default")
        ->type_name("DT")
        ->check(reduced("tau", ljmd::Dimension::time));
    command
        .add_option("--group", options.group, "of an H5MD file with several groups of particles, the one to measure")
        ->type_name("NAME");
    command
        .add_option("--positions", options.positions,
                    "wrapped or unwrapped, for displacements in trajectories where neither the file nor the motion of "
                    "the atoms tells")
        ->type_name("HOW")
        ->check(CLI::IsMember({"wrapped", "unwrapped"}));
    command
        .add_option("--xyz-comment", options.xyz_comment,
                    "what the comment lines of an XYZ file lack, e.g. 'Lattice=\"20 0 0 0 20 0 0 0 20\" units=si'")
        ->type_name("KEY=VALUE...");
    command.add_option("--set", options.settings, "e.g. --set analysis.rdf.bins=100; `every` counts frames")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        .add_option("--out", options.out,
                    "directory for the tables; by default RUNDIR/analysis, or NAME-analysis beside the trajectory")
        ->type_name("DIR");
    command.add_flag("--force", options.force, "replace the tables of an earlier analysis");
    command.add_flag("--json", options.json, "print the result as JSON");
}

void add_plot_options(CLI::App& command, ljmd::PlotOptions& options) {
    command
        .add_option(
            "path", options.path,
            "directory of a run, an analysis, a sweep, a reproduced table or a comparison; or one of their tables")
        ->required()
        ->type_name("DIR|FILE");
    command
        .add_option(
            "names", options.names,
            "pictures to draw, e.g. thermo rdf; of a sweep its columns, e.g. pressure; all that suit by default")
        ->type_name("NAME");
    command
        .add_option(
            "--out", options.out,
            "file that ends in .png, .svg or .pdf (several pictures add their names), or a directory; DIR by default")
        ->type_name("FILE");
    command.add_option("--against", options.against, "of a sweep: the varied key on the axis, the last by default")
        ->type_name("KEY");
    command
        .add_option("--relative-to", options.relative_to,
                    "of few bodies: the body from which the others are seen, counted from 1")
        ->type_name("K")
        ->check(CLI::PositiveNumber);
    command.add_flag("--force", options.force, "replace files that are no pictures of ljmd");
}

constexpr int usage_error = 2;

/// Print the text for --help or --version.
int print_help(const CLI::App& app, const CLI::Success& asked) try {
    std::ostringstream text;
    const int code = app.exit(asked, text);
    ljmd::print_result(text.str());
    return code;
} catch (...) {
    return ljmd::report_current_exception();
}

}  // namespace

int main(int argc, char** argv) {
    ljmd::forget_inherited_signals();
    ljmd::prepare_standard_streams();
    ljmd::leave_hdf5_files_at_exit();
    CLI::App app("Lennard-Jones molecular dynamics: Verlet's 1967 experiment and beyond", "ljmd");
    app.formatter(ljmd::screen_formatter());
    app.require_subcommand(1);
    app.set_version_flag("--version", "ljmd " + ljmd::build_info().version);

    ljmd::DeckOptions options;
    ljmd::ResumeOptions resumed;
    std::string out;
    std::string walltime;
    Several several;
    ljmd::CrosscheckOptions compared;
    std::string to;
    ljmd::InfoOptions told;
    CLI::App& run = *app.add_subcommand("run", "run a deck and write its results");
    add_deck_options(run, options);
    run.add_option("--out", out, "output directory, instead of the deck's")->type_name("DIR");
    run.add_option("--walltime", walltime, "stop after that long with a checkpoint: 90s, 30min, 2h, 1d")
        ->type_name("TIME")
        ->excludes(add_replica_options(run, several));
    CLI::App& resume = *app.add_subcommand("resume", "resume a run that was stopped, from its last checkpoint");
    resume.add_option("directory", resumed.directory, "directory of the run")->required()->type_name("RUNDIR");
    resume.add_option("--steps", resumed.more_steps, "add steps to the last stage: +N")
        ->type_name("+N")
        ->check(CLI::Range(ljmd::Index{1}, ljmd::max_steps));
    resume.add_option("--walltime", resumed.walltime, "stop after that long with a checkpoint: 90s, 30min, 2h, 1d")
        ->type_name("TIME");
    resume.add_option("--threads", resumed.threads, "threads to share the work; as many as before by default")
        ->type_name("N")
        ->check(CLI::Range(1, ljmd::max_threads));
    resume.add_option("--jobs", several.jobs, "of replicas: at a time; one for each processor by default")
        ->type_name("N")
        ->check(CLI::Range(1, ljmd::max_threads));
    resume.add_flag("--quiet", resumed.quiet, "no progress");
    resume.add_flag("--json", resumed.json, "print the result as JSON");
    CLI::App& check = *app.add_subcommand("check", "find every mistake in a deck, and estimate its cost");
    add_deck_options(check, options);
    CLI::App& compare = *app.add_subcommand("compare", "compare a deck's motion with that of an independent program");
    add_deck_options(compare, options);
    add_compare_options(compare, compared);
    compare.add_option("--out", out, "write the comparison into this directory too")->type_name("DIR");
    CLI::App& convert = *app.add_subcommand(
        "export", "write the start of a deck, or the end of a run, for another program; nothing is run");
    add_deck_options(convert, options);
    convert.get_option("deck")->description("deck (TOML), or directory of a run")->type_name("DECK|RUNDIR");
    convert
        .add_option("--to", to,
                    fmt::format("{}: the last two are configurations alone", fmt::join(ljmd::export_targets(), ", ")))
        ->required()
        ->type_name("TARGET");
    convert.add_option("--out", out, "directory for the files; by default NAME-TARGET in the working directory")
        ->type_name("DIR");
    bool forces = false;
    convert.add_flag("--forces", forces, "extxyz, h5md: with the forces on the atoms, by the deck's potential");
    CLI::App& bench = *app.add_subcommand(
        "bench", "measure how fast a deck runs; without one, the Lennard-Jones melt of 32000 atoms");
    add_deck_options(bench, options, false);
    ljmd::EosOptions state;
    CLI::App& eos =
        *app.add_subcommand("eos",
                            "equations of state of the Lennard-Jones fluid: a state from a temperature with a density "
                            "or a pressure; coexistence from a temperature or a pressure alone; tables from ranges");
    eos.add_option("--temperature", state.temperature, "in epsilon/k_B: a number, FROM:TO:COUNT or A|B|C")
        ->type_name("T")
        ->check(each_reduced("epsilon/k_B", ljmd::Dimension::temperature));
    eos.add_option("--density", state.density, "atoms per sigma^3, as the temperature")
        ->type_name("RHO")
        ->check(each_reduced("atoms per sigma^3", ljmd::Dimension::density));
    eos.add_option("--pressure", state.pressure, "in epsilon/sigma^3, as the temperature; instead of a density")
        ->type_name("P")
        ->check(each_reduced("epsilon/sigma^3", ljmd::Dimension::pressure));
    eos.add_option("--model", state.model, "one that `ljmd eos` lists, thol2016 by default")->type_name("EQUATION");
    eos.add_flag("--csv", state.csv, "print it as CSV, with a column for each property");
    eos.add_flag("--json", state.json, "print it as JSON");
    ljmd::ReproduceCommand reproduce(app);
    ljmd::ReferenceCommand reference(app);
    ljmd::SweepCommand sweep(app);
    ljmd::AnalyzeOptions analyzed;
    CLI::App& analyze = *app.add_subcommand(
        "analyze", "where a run has come to equilibrium; structure and transport from the frames of a trajectory");
    add_analyze_options(analyze, analyzed);
    ljmd::EvaluateCommand evaluate(app);
    ljmd::ReportOptions reported;
    CLI::App& report = *app.add_subcommand(
        "report", "write one HTML page about a run, a sweep, a reproduced table or a comparison, or about several");
    report
        .add_option("directory", reported.directories, "directory of a run, a sweep, a reproduced table, a comparison")
        ->required()
        ->type_name("RUN");
    report
        .add_option("--out", reported.out,
                    "file to write, RUN/report.html by default; for several report.html in the working directory")
        ->type_name("FILE");
    report.add_flag("--force", reported.force, "replace a file that is no page of ljmd");
    CLI::Option* opened = report.add_flag("--open", reported.open, "open the page in a browser");
    report.add_flag("--json", reported.json, "print the data of the page as JSON, and write no page")->excludes(opened);
    ljmd::PlotOptions drawn;
    CLI::App& plot = *app.add_subcommand("plot", "draw the pictures of a run, a sweep, a comparison or a table");
    add_plot_options(plot, drawn);
    CLI::App& info =
        *app.add_subcommand("info", "version, build and what decks can select; of a run or sweep, how far it got");
    CLI::Option* of_run =
        info.add_option("directory", told.directory, "directory of a run, a sweep or a reproduced table")
            ->type_name("RUNDIR");
    CLI::Option* page = info.add_flag("--keys", told.keys, "the reference page of all deck keys, in Markdown");
    page->excludes(of_run);
    CLI::Option* schema =
        info.add_flag("--schema", told.schema, "a JSON Schema of decks, with which editors complete and check");
    schema->excludes(of_run)->excludes(page);
    info.add_flag("--json", told.json, "print it as JSON")->excludes(page)->excludes(schema);

    ljmd::OwnCommands own(app);

    if (argc < 2) {
        ljmd::print_message(ljmd::is_first_launched() ? app.help() : "");
        return usage_error;
    }
    const bool is_heard = ljmd::is_first_launched();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return is_heard ? print_help(app, help) : 0;
    } catch (const CLI::ParseError& error) {
        return is_heard ? ljmd::report_usage(app, error) : usage_error;
    }
    try {
        if (!(run.parsed() && several.replicas == 0) &&
            !(resume.parsed() && !ljmd::holds_replicas(resumed.directory))) {
            ljmd::refuse_ranks(app.get_subcommands().front()->get_name());
        }
        if (run.parsed() && several.replicas > 0) {
            ljmd::replicas_command(options, out, several.replicas, several.jobs);
        } else if (run.parsed()) {
            ljmd::run_command(options, out, walltime);
        } else if (resume.parsed() && ljmd::holds_replicas(resumed.directory)) {
            ljmd::resume_replicas(resumed, several.jobs);
        } else if (resume.parsed()) {
            ljmd::resume_command(resumed);
        } else if (check.parsed()) {
            ljmd::check_command(options);
        } else if (compare.parsed()) {
            ljmd::compare_command(options, compared, out);
        } else if (convert.parsed()) {
            ljmd::export_command(options, to, out, forces);
        } else if (eos.parsed()) {
            ljmd::eos_command(state);
        } else if (reproduce.parsed()) {
            reproduce.run();
        } else if (reference.parsed()) {
            reference.run();
        } else if (sweep.parsed()) {
            sweep.run();
        } else if (analyze.parsed()) {
            ljmd::analyze_command(analyzed);
        } else if (evaluate.parsed()) {
            evaluate.run();
        } else if (report.parsed()) {
            ljmd::report_command(reported);
        } else if (bench.parsed()) {
            ljmd::bench_command(options);
        } else if (plot.parsed()) {
            ljmd::plot_command(drawn);
        } else if (own.parsed()) {
            return own.run();
        } else {
            ljmd::info_command(told);
        }
    } catch (...) {
        return ljmd::end_after_exception();
    }
    return 0;
}
