#include <fmt/format.h>

#include <filesystem>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/signals.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/execution/simd.hpp"
#include "ljmd/input/deck_file.hpp"
#include "ljmd/io/files/directory_lock.hpp"
#include "ljmd/io/files/replacement_file.hpp"
#include "ljmd/run/run_directory.hpp"
#include "ljmd/study/child_run.hpp"
#include "ljmd/study/sweep_record.hpp"
#include "ljmd/study/sweep_report.hpp"
#include "ljmd/study/sweep_sense.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// A point being computed, by one run.
class PointRun {
  public:
    PointRun(ChildRun run, std::vector<std::string> values)
        : run_(std::move(run)), point_{run_.name, std::move(values), run_.directory, {}, "", {}} {}

    [[nodiscard]] const SweptPoint& point() const { return point_; }

    /// The job of the point; nothing if it is finished.
    std::optional<Job> begin() {
        auto job = next_job(run_);
        if (!job) {
            take_results();
        }
        return job;
    }

    /// Take the results; there is no further job.
    std::optional<Job> after(int exit_status) {
        if (exit_status == 0) {
            take_results();
        } else {
            point_.failure = failure_of(run_, exit_status);
        }
        return std::nullopt;
    }

  private:
    void take_results() {
        try {
            RecordedResults results = read_results(run_.directory / "results.json");
            point_.found = std::move(results.means);
            point_.doubts = std::move(results.doubts);
        } catch (const DataError& error) {
            point_.failure = fmt::format("{}: {}", run_.name, error.what());
        }
    }

    ChildRun run_;
    SweptPoint point_;
};

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
    if (!options.quiet) {
        print_warnings(diagnostics);
    }
    return plan;
}

fs::path directory_of(const SweepOptions& options) {
    return options.out.empty() ? fs::path("runs") / fs::path(options.deck).stem().concat("-sweep")
                               : fs::path(options.out);
}

/// Run all points to their ends. @throws InUseError  the directory was moved meanwhile
SweptPoints sweep(const SweepPlan& plan, const OpenDirectory& directory, const SweepOptions& options) {
    std::vector<PointRun> runs;
    for (ChildRun& run : sweep_runs(plan, directory.path())) {
        runs.emplace_back(std::move(run), plan.points.values[runs.size()]);
    }
    run_lines(runs, options.jobs, until_signal(), [&](const PointRun& run, std::size_t done) {
        directory.require_at_its_path();  // runs are started by path
        const SweptPoint& point = run.point();
        if (!point.failure.empty()) {
            warn(point.failure);
        } else if (!options.quiet) {
            print_message(fmt::format("[{}/{}] {}: {}\n", done, runs.size(), point.name, point_line(point)));
        }
    });
    SweptPoints swept{plan.points.keys, {}};
    for (const PointRun& run : runs) {
        swept.points.push_back(run.point());
    }
    return swept;
}

/// @throws PhysicsError  if any points have failed
void tell_of_failures(const SweptPoints& swept) {
    std::string failures;
    std::size_t count = 0;
    for (const SweptPoint& point : swept.points) {
        if (!point.failure.empty()) {
            failures += "\n  " + point.failure;
            ++count;
        }
    }
    if (count > 0) {
        throw PhysicsError(fmt::format("{} of {} points failed; the same command tries them again{}", count,
                                       swept.points.size(), failures));
    }
}

}  // namespace

void sweep_command(const SweepOptions& options) {
    install_stop_handlers();
    static_cast<void>(default_simd_level());  // report a wrong LJMD_SIMD before anything is done
    const SweepPlan plan = checked_plan(options);
    const fs::path directory = directory_of(options);
    make_directory(directory);
    const DirectoryLock lock(directory);
    wait_for_runs(directory / "points", until_signal(), print_message);
    prepare_sweep(plan, lock.directory(), options.force);
    const SweptPoints swept = sweep(plan, lock.directory(), options);
    lock.directory().require_at_its_path();
    write_file_atomically(lock.directory() / "sweep.csv", sweep_csv(swept));
    Document report = sweep_report(swept, result_columns());
    report.text += fmt::format("\nfiles: {0}\nto draw them: ljmd plot {0}\n", directory.string());
    print_document(report, options.json);
    tell_of_failures(swept);
}

}  // namespace ljmd
