#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/studies/study_mode_options.hpp"
#include "cli/studies/study_steps.hpp"
#include "deck/deck.hpp"
#include "input/deck_file.hpp"
#include "io/files/claimed_file.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/replacement_file.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/execution/simd.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"
#include "study/point_run.hpp"
#include "study/slurm_array.hpp"
#include "study/sweep_sense.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd sweep`. Points come from `grids` or from `list`.
struct SweepOptions {
    std::string deck;                     ///< of a worker and for the status the directory
    std::vector<std::string> grids{};     ///< "KEY=FROM:TO:COUNT,KEY=A|B|C", see grid_points()
    std::string list{};                   ///< CSV file, see list_points()
    std::vector<std::string> settings{};  ///< arguments of --set
    bool seeds = false;                   ///< each point has its own
    std::string out{};                    ///< directory; empty: runs/<deck>-sweep
    int jobs = 0;                         ///< points at a time; 0: the number of processors
    bool force = false;
    bool quiet = false;
    bool json = false;
    StudyMode mode{};
};

/// The seed that --seeds counts from. @pre the points are good
std::uint64_t seed_of(const Source& deck, const SweepPlan& plan) {
    Diagnostics diagnostics;
    std::vector<std::string> settings = plan.settings;
    for (const std::string& setting : point_settings(plan.points, 0)) {
        settings.push_back(setting);
    }
    const auto first = load_deck_text(deck.name, deck.text, settings, true, diagnostics);
    diagnostics.throw_if_errors();
    if (!first->is_fluid()) {
        throw InputError("--seeds: few bodies have no seed. Nothing was run.");
    }
    return static_cast<std::uint64_t>(first->system().seed);
}

/// The checked deck and points: all mistakes are reported before any file is touched.
SweepPlan checked_plan(const SweepOptions& options) {
    if (options.grids.empty() == options.list.empty()) {
        throw InputError("a sweep wants its points from --grid or from --list, one of the two");
    }
    Diagnostics diagnostics;
    const DeckFile deck = read_deck(options.deck, diagnostics);
    diagnostics.throw_if_errors();
    SweepPlan plan{options.deck, deck.source->text, options.settings,
                   options.list.empty() ? grid_points(options.grids, options.settings, diagnostics)
                                        : list_points(options.list, options.settings, diagnostics)};
    diagnostics.throw_if_errors();
    check_points(*deck.source, plan.settings, plan.points, options.list.empty() ? "--grid" : "--list", options.force,
                 diagnostics);
    diagnostics.throw_if_errors();
    if (options.seeds) {
        plan.points = with_seeds(plan.points, seed_of(*deck.source, plan));
    }
    if (!options.quiet) {
        print_warnings(diagnostics);
    }
    return plan;
}

fs::path directory_of(const SweepOptions& options) {
    return options.out.empty() ? fs::path("runs") / output_name(fs::path(options.deck).stem().string(), "-sweep")
                               : fs::path(options.out);
}

constexpr const char* shared_seed = "All points have one seed, and deviate alike; --seeds gives each its own.\n";

void tell_point(const RunLine& line, std::size_t done, std::size_t all) {
    const SweptPoint& point = dynamic_cast<const PointRun&>(line).point();
    print_message(fmt::format("[{}/{}] {}: {}\n", done, all, point.name, point_line(point)));
}

/// A worker. @throws InputError  the directory holds no sweep
void work_on_sweep(const SweepOptions& options) {
    const fs::path directory = options.deck;
    const auto refuse = [&](const std::string& what) {
        return InputError(fmt::format("--work: {} holds {}. Nothing was run.", directory.string(), what));
    };
    if (!files::exists(directory / "points")) {
        throw refuse(files::exists(directory / "rows") ? "a reproduced table: `ljmd reproduce --work`"
                                                       : "no sweep; `ljmd sweep DECK --grid ... --prepare` makes one");
    }
    const SharedDirectory shared(directory / "points");
    const auto plan = recorded_sweep(directory);
    if (!plan) {
        throw refuse("no sweep; `ljmd sweep DECK --grid ... --prepare` makes one");
    }
    if (plan->replicas > 0) {
        throw refuse("replicas: `ljmd resume`");
    }
    std::vector<PointRun> runs = point_runs(*plan, directory);
    work_on(sweep_words(), options.mode, pointers_to(runs), shared.directory(), options.jobs,
            options.quiet ? TellRun() : tell_point);
}

/// Write and print the table. @return why points have failed
std::vector<std::string> print_table(const SweepPlan& plan, const std::vector<PointRun>& runs,
                                     const OpenDirectory& directory, bool as_json) {
    SweptPoints swept{plan.points.keys, {}};
    std::vector<std::string> failures;
    for (const PointRun& run : runs) {
        swept.points.push_back(run.point());
        if (!run.failure().empty()) {
            failures.push_back(run.failure());
        }
    }
    directory.require_at_its_path();
    write_file_atomically(directory / "sweep.csv", sweep_csv(swept));
    Document report = sweep_report(swept, result_columns());
    if (swept.points.size() > 1 && std::ranges::find(swept.keys, seed_key) == swept.keys.end()) {
        report.text += shared_seed;
    }
    report.text += told_files(directory.path());
    print_document(report, as_json);
    return failures;
}

class SweepCommand : public Command {
  public:
    SweepCommand()
        : Command("sweep", Part::studies,
                  "run a deck at many settings, several at a time; an interrupted sweep is resumed") {}

    void add_options(CLI::App& command) override {
        command
            .add_option("deck", options_.deck,
                        "deck (TOML); with --work and --status the directory of a prepared sweep")
            ->required()
            ->type_name("DECK|DIR");
        command
            .add_option("--grid", options_.grids,
                        "keys to vary, between commas: numbers at equal distances, KEY=FROM:TO:COUNT, or a list, "
                        "KEY=A|B|C; "
                        "all combinations are run, at most 10000")
            ->type_name("KEY=VALUES,...")
            ->allow_extra_args(false);
        command
            .add_option("--list", options_.list, "points to run instead: CSV with a header of keys, each row a point")
            ->type_name("FILE");
        command.add_option("--set", options_.settings, "replace a value of the deck at all points")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        command.add_flag(
            "--seeds", options_.seeds,
            "each point has a seed of its own, counted up from the deck's; without it all points have one, "
            "and deviate alike");
        add_jobs(command, options_.jobs,
                 "points at a time; one for each processor by default, with --slurm one in each task");
        command.add_option("--out", options_.out, "directory, runs/DECK-sweep by default")->type_name("DIR");
        command.add_flag("--force", options_.force, "accept unlikely values; replace another sweep");
        command.add_flag("--quiet", options_.quiet, "no progress, no warnings about the deck");
        command.add_flag("--json", options_.json, "print the table, or the status, as JSON");
        add_study_mode(command, options_.mode);
    }

    void run() override {
        if (options_.mode.status) {
            print_status(sweep_words(), options_.deck, options_.json);
            return;
        }
        install_stop_handlers();
        static_cast<void>(default_simd_level());  // report a wrong LJMD_SIMD before anything is done
        if (!options_.mode.work.empty()) {
            work_on_sweep(options_);
            return;
        }
        const fs::path path = directory_of(options_);
        std::optional<SlurmArray> array;
        if (options_.mode.slurm) {
            array.emplace("sweep", path, *options_.mode.slurm, until_signal());
        }
        const SweepPlan plan = checked_plan(options_);
        make_directory(path);
        const DirectoryLock lock(path);
        const OpenDirectory& directory = lock.directory();
        if (array) {
            array->require_none();
        }
        prepare_sweep(plan, directory, options_.force, wait_for_writing_runs);
        std::vector<PointRun> runs = point_runs(plan, path);
        if (options_.mode.prepare) {
            print_prepared(sweep_words(), path, runs.size(), options_.json);
        } else if (array) {
            submit_missing(sweep_words(), *array, pointers_to(runs), directory,
                           {options_.jobs, options_.force, options_.json},
                           [&] { return print_table(plan, runs, directory, options_.json); });
        } else {
            run_all(pointers_to(runs), directory, options_.jobs, until_signal(),
                    options_.quiet ? TellRun() : tell_point);
            throw_failures(sweep_words(), print_table(plan, runs, directory, options_.json), runs.size(),
                           "the same command tries them again");
        }
    }

  private:
    SweepOptions options_;
};

}  // namespace

std::shared_ptr<Command> sweep_command() {
    return std::make_shared<SweepCommand>();
}

}  // namespace ljmd
