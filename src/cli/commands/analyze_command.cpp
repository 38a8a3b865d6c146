#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analyze/thermo_report.hpp"
#include "analyze/trajectory_analysis.hpp"
#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"
#include "deck/deck_system.hpp"
#include "io/files/input_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"
#include "run/recorded_run.hpp"
#include "run/results.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd analyze`.
struct AnalyzeOptions {
    std::string path;                     ///< directory of a run, or a trajectory
    std::vector<std::string> names{};     ///< of analyses, and "thermo"; empty: the default ones
    std::string deck{};                   ///< for a trajectory; empty: none
    std::vector<std::string> settings{};  ///< arguments of --set
    std::optional<double> from{};         ///< start of the measurement [tau]
    std::optional<double> time_step{};    ///< for frames without times [tau]
    std::string group{};                  ///< particle group of an H5MD file; empty: the only one
    std::string positions{};    ///< "wrapped", "unwrapped"; empty: determined from the file or the displacements
    std::string xyz_comment{};  ///< keys missing from the comment lines of an extended XYZ file
    std::string out{};          ///< directory for the tables
    bool force = false;
    bool json = false;
};

const std::string thermo = "thermo";

/// The requested analyses, without repetition, in the order of the command line.
struct Wanted {
    bool thermo = false;
    std::vector<std::string> analyses;
};

Wanted wanted(const AnalyzeOptions& options) {
    check_analysis_names(options.names);
    Wanted wanted;
    for (const std::string& name : options.names) {
        if (name == thermo) {
            wanted.thermo = true;
        } else if (std::ranges::find(wanted.analyses, name) == wanted.analyses.end()) {
            wanted.analyses.push_back(name);
        }
    }
    for (const auto& [option, time] : {std::pair{"--from", options.from}, {"--time-step", options.time_step}}) {
        if (time && !std::isfinite(*time)) {
            throw InputError(fmt::format("{}: {} is no time", option, *time));
        }
    }
    if (options.time_step && *options.time_step <= 0.0) {
        throw InputError(fmt::format("--time-step must be above 0, found {}", *options.time_step));
    }
    return wanted;
}

/// Refuse a directory that the tables cannot be written to.
void check_out(const fs::path& directory, const std::vector<std::string>& files, bool force) {
    require_no_run(directory, "Nothing was written");
    require_no_outputs(directory, files, force, "Nothing was written");
}

std::vector<std::string> output_files(const std::vector<FrameAnalysis>& analyses) {
    std::vector<std::string> files;
    for (const FrameAnalysis& each : analyses) {
        for (const std::string& file : each.method.files) {
            files.push_back(file + ".csv");
        }
    }
    return files;
}

std::optional<Positions> said_positions(const AnalyzeOptions& options) {
    if (options.positions.empty()) {
        return std::nullopt;
    }
    return options.positions == "wrapped" ? Positions::wrapped : Positions::unwrapped;
}

/// Analyse a trajectory and write the tables.
/// @param is_run  the deck is from the run that wrote the trajectory
Document analyze(const fs::path& path, const Deck* deck, bool is_run, const Wanted& wanted,
                 const AnalyzeOptions& options, const fs::path& directory) {
    const AnalyzedTrajectory trajectory = trajectory_to_analyze(
        path, deck, is_run, wanted.thermo && !is_run,  // for a run, thermo reads thermo.csv instead
        {.from = options.from,
         .time_step = options.time_step,
         .group = options.group,
         .positions = said_positions(options),
         .xyz_comment = options.xyz_comment});
    std::vector<std::string> names = wanted.analyses;
    if (!trajectory.thermo && names.empty()) {
        names = default_analyses(trajectory.summary, trajectory.selection);
        const FrameSelection& selection = trajectory.selection;
        if (!selection.spacing && selection.used > 1 && !trajectory.summary.box_changes) {
            warn(fmt::format("msd is left out: {}", selection.uneven));
        } else if (!trajectory.summary.positions.positions) {
            warn(fmt::format("msd is left out: {}", trajectory.summary.positions.reason));
        } else if (trajectory.summary.is_part) {
            warn(fmt::format("msd is left out: {}", part_of_the_atoms));
        }
    }
    const std::vector<FrameAnalysis> analyses =
        make_frame_analyses(names, options.settings, deck, trajectory.summary, trajectory.selection);
    check_out(directory, output_files(analyses), options.force);

    const TrajectoryResult result = analyze_trajectory(trajectory, analyses);
    for (const std::string& warning : result.warnings) {
        warn(warning);
    }
    if (!result.tables.empty()) {
        make_directory(directory);
    }
    for (const DataTable& table : result.tables) {
        write_output(directory / (table.name + ".csv"), {.force = options.force, .instead = another_directory},
                     to_csv(with_si_columns(table, trajectory.units())));
    }
    Document document = trajectory_document(trajectory, result);
    if (!result.tables.empty()) {
        document.text += fmt::format("\nfiles: {}\n", directory.string());
    }
    return document;
}

void analyze_file(const AnalyzeOptions& options, const Wanted& wanted) {
    std::optional<Deck> deck;
    if (!options.deck.empty()) {
        Diagnostics diagnostics;
        deck = load_deck(options.deck, {}, true, diagnostics);
        diagnostics.throw_if_errors();
        require_fluid(*deck,
                      fmt::format("{} is a few-body deck: a trajectory of a fluid wants that of one", options.deck));
    }
    const fs::path path(options.path);
    const fs::path directory = options.out.empty() ? path.parent_path() / output_name(path.stem().string(), "-analysis")
                                                   : fs::path(options.out);
    print_document(analyze(path, deck ? &*deck : nullptr, false, wanted, options, directory), options.json);
}

/// The trajectory written by a run.
fs::path trajectory_of(const Deck& deck) {
    require_fluid(deck, "a few-body run has no box: `ljmd analyze` wants one of a fluid");
    if (!deck.trajectory) {
        throw DataError(
            fmt::format("{} has no trajectory: its deck has no 'trajectory' in [output]", deck.directory.string()));
    }
    return deck.directory / fmt::format("trajectory.{}", deck.trajectory->format);
}

void analyze_run(const AnalyzeOptions& options, const Wanted& wanted) {
    if (!options.deck.empty()) {
        throw InputError("--deck is for a trajectory alone; a run has its own deck");
    }
    if (wanted.analyses.empty() && (!options.settings.empty() || !options.out.empty() || options.time_step)) {
        throw InputError(
            "--set, --out and --time-step go with an analysis of frames, such as rdf; thermo of a run looks at its "
            "thermo.csv and writes nothing");
    }
    if (!options.xyz_comment.empty()) {
        throw InputError("--xyz-comment is for a trajectory alone; that of a run says all");
    }
    const RecordedRun run = recorded_run(options.path);
    std::optional<ThermoReport> report;
    if (wanted.thermo || wanted.analyses.empty()) {
        report = thermo_report(run, options.from);
    }
    if (wanted.analyses.empty()) {
        print_document(thermo_document(*report), options.json);
        return;
    }
    const fs::path directory = options.out.empty() ? fs::path(options.path) / "analysis" : fs::path(options.out);
    Document document = analyze(trajectory_of(run.deck), &run.deck, true, wanted, options, directory);
    if (report) {
        const Document before = thermo_document(*report);
        document.data[thermo] = before.data;
        document.text = fmt::format("{}\n{}", before.text, document.text);
    }
    print_document(document, options.json);
}

class AnalyzeCommand : public Command {
  public:
    AnalyzeCommand()
        : Command("analyze", Part::results,
                  "where a run has come to equilibrium; structure and transport from the frames of a trajectory") {}

    void add_options(CLI::App& command) override {
        command
            .add_option("path", options_.path, "directory of a run; or a trajectory: H5MD, extended XYZ, LAMMPS dump")
            ->required()
            ->type_name("RUNDIR|TRAJECTORY");
        command
            .add_option(
                "analysis", options_.names,
                fmt::format("{}, thermo; by default thermo of a run, rdf, structure_factor and msd of a trajectory",
                            fmt::join(plugin_names(all_analyses()), ", ")))
            ->type_name("ANALYSIS");
        command
            .add_option("--deck", options_.deck,
                        "of a trajectory: interaction, [analysis], and [argon] for files in SI units")
            ->type_name("DECK");
        command.add_option("--from", options_.from, "leave out what is before this time, in tau")
            ->type_name("T")
            ->check(reduced("tau", Dimension::time));
        command
            .add_option("--time-step", options_.time_step,
                        "time between steps in tau, for trajectories that do not tell; that of the deck by default")
            ->type_name("DT")
            ->check(reduced("tau", Dimension::time));
        command
            .add_option("--group", options_.group,
                        "of an H5MD file with several groups of particles, the one to measure")
            ->type_name("NAME");
        command
            .add_option(
                "--positions", options_.positions,
                "wrapped or unwrapped, for displacements in trajectories where neither the file nor the motion of "
                "the atoms tells")
            ->type_name("HOW")
            ->check(CLI::IsMember({"wrapped", "unwrapped"}));
        command
            .add_option("--xyz-comment", options_.xyz_comment,
                        "what the comment lines of an XYZ file lack, e.g. 'Lattice=\"20 0 0 0 20 0 0 0 20\" units=si'")
            ->type_name("KEY=VALUE...");
        command.add_option("--set", options_.settings, "e.g. --set analysis.rdf.bins=100; `every` counts frames")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        command
            .add_option("--out", options_.out,
                        "directory for the tables; by default RUNDIR/analysis, or NAME-analysis beside the trajectory")
            ->type_name("DIR");
        command.add_flag("--force", options_.force, "replace the tables of an earlier analysis");
        command.add_flag("--json", options_.json, "print the result as JSON");
    }

    void run() override {
        const Wanted names = wanted(options_);
        if (input_is_directory(options_.path)) {
            analyze_run(options_, names);
        } else {
            analyze_file(options_, names);
        }
    }

  private:
    AnalyzeOptions options_;
};

}  // namespace

std::shared_ptr<Command> analyze_command() {
    return std::make_shared<AnalyzeCommand>();
}

}  // namespace ljmd
