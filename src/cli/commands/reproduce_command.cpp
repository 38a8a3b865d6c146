#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/signals.hpp"
#include "cli/streams.hpp"
#include "cli/studies/study_mode_options.hpp"
#include "cli/studies/study_steps.hpp"
#include "core/text.hpp"
#include "io/files/claimed_file.hpp"
#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/replacement_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"
#include "study/reproduction_report.hpp"
#include "study/row_run.hpp"
#include "study/slurm_array.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd reproduce`.
struct ReproduceOptions {
    std::string what;                 ///< "verlet1967"; of a worker and for the status the directory
    std::string out;                  ///< directory
    std::vector<std::string> rows{};  ///< "RHO" or "RHO:T"; empty: all
    int jobs = 0;                     ///< rows at a time; 0: the number of processors
    bool quick = false;               ///< as short as Verlet's own runs
    bool force = false;
    bool quiet = false;
    bool json = false;
    StudyMode mode{};
};

/// The rows for "RHO" or "RHO:T". @throws InputError  there are none
std::vector<VerletRow> rows_meant(const std::string& word) {
    const std::size_t colon = word.find(':');
    const auto density = to_number(std::string_view(word).substr(0, colon));
    const auto temperature =
        colon == std::string::npos ? std::nullopt : to_number(std::string_view(word).substr(colon + 1));
    std::vector<VerletRow> found;
    for (const VerletRow& row : verlet1967_table()) {
        if (density == row.density && (colon == std::string::npos || temperature == row.temperature)) {
            found.push_back(row);
        }
    }
    if (found.empty()) {
        throw InputError(fmt::format(
            "--rows: the table has no row '{}'; a density, as in 0.85, means all of its rows, 0.85:0.786 one of them",
            word));
    }
    return found;
}

/// The requested rows, in the order of the table, without repetition.
std::vector<VerletRow> chosen_rows(const std::vector<std::string>& words) {
    if (words.empty()) {
        return verlet1967_table();
    }
    std::vector<std::string> wanted;
    for (const std::string& word : words) {
        for (const VerletRow& row : rows_meant(word)) {
            wanted.push_back(row_name(row));
        }
    }
    std::vector<VerletRow> rows;
    for (const VerletRow& row : verlet1967_table()) {
        if (std::find(wanted.begin(), wanted.end(), row_name(row)) != wanted.end()) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// Refuse a directory whose files are not those of a reproduced table. @throws InputError, DataError
void require_usable(const fs::path& out, const std::vector<RowRun>& runs, bool force) {
    const std::string consequence = "Nothing was run";
    require_no_run(out, consequence);
    const bool replaces = force || recorded_reproduction(out);
    require_no_outputs(out, {"rows.csv", "isotherms.csv", "rows.md", "results.json"}, replaces, consequence);
    for (const RowRun& run : runs) {  // the decks may be there before the record
        require_writable(
            run.run().deck,
            {.force = replaces, .mark = run.run().source, .consequence = consequence, .instead = another_directory});
    }
    std::ranges::for_each(runs, [&](const RowRun& run) { run.check(force); });
}

void tell_row(const RunLine& line, std::size_t done, std::size_t all) {
    const auto& [verlet, steps, temperature, z, u, beyond, thol, kolafa] = *dynamic_cast<const RowRun&>(line).result();
    print_message(fmt::format("[{}/{}] rho {} T {}: Z {}, U {} in {} steps\n", done, all, verlet.density,
                              verlet.temperature, with_error(z.mean, z.standard_error),
                              with_error(u.mean, u.standard_error), steps));
}

/// A worker. @throws InputError  the directory holds no reproduced table that was prepared
void work_on_table(const ReproduceOptions& options) {
    const fs::path directory = options.what;
    const auto no_table = [&] {
        return InputError(
            fmt::format("--work: {} holds no reproduced table; `ljmd reproduce TABLE --prepare` makes one. "
                        "Nothing was run.",
                        directory.string()));
    };
    if (!files::exists(directory / rows_folder)) {
        throw no_table();
    }
    const SharedDirectory shared(directory / rows_folder);
    const auto plan = recorded_reproduction(directory);
    if (!plan) {
        throw no_table();
    }
    std::vector<RowRun> runs = row_runs(*plan, directory);
    work_on(reproduction_words(), options.mode, pointers_to(runs), shared.directory(), options.jobs,
            options.quiet ? TellRun() : tell_row);
}

/// Write and print the table. @return why rows have failed
std::vector<std::string> print_rows(const std::vector<RowRun>& runs, const OpenDirectory& directory, bool as_json) {
    std::vector<ReproducedRow> rows;
    std::vector<std::string> failures;
    for (const RowRun& run : runs) {
        if (run.failure().empty()) {
            rows.push_back(*run.result());
        } else {
            failures.push_back(run.failure());
        }
    }
    directory.require_at_its_path();
    write_file_atomically(directory / "rows.csv", reproduction_csv(rows));
    write_file_atomically(directory / "isotherms.csv", isotherms_csv());
    write_file_atomically(directory / "rows.md", reproduction_markdown(rows));
    Document report = reproduction_report(rows, result_columns());
    write_file_atomically(directory / "results.json", to_json(report.data) + "\n");
    report.text += told_files(directory.path());
    print_document(report, as_json);
    return failures;
}

class ReproduceCommand : public Command {
  public:
    ReproduceCommand()
        : Command("reproduce", Part::studies,
                  "compute a published table anew, with error bars; an interrupted one is resumed") {}

    void add_options(CLI::App& command) override {
        command
            .add_option("table", options_.what,
                        "verlet1967: Phys. Rev. 159, 98; with --work and --status the directory of a prepared table")
            ->required()
            ->type_name("TABLE|DIR");
        command.add_option("--rows", options_.rows, "some of the rows: a density, or density:temperature")
            ->type_name("RHO[:T],...")
            ->delimiter(',');
        add_jobs(command, options_.jobs,
                 "rows at a time; one for each processor by default, with --slurm one in each task");
        command.add_option("--out", options_.out, "directory, runs/verlet1967 by default")->type_name("DIR");
        command.add_flag("--quick", options_.quick, "runs as short as Verlet's own, 1200 steps");
        command.add_flag("--force", options_.force, "begin rows anew whose directory holds another run");
        command.add_flag("--quiet", options_.quiet, "no progress");
        command.add_flag("--json", options_.json, "print the table, or the status, as JSON");
        add_study_mode(command, options_.mode);
    }

    void run() override {
        if (options_.mode.status) {
            print_status(reproduction_words(), options_.what, options_.json);
            return;
        }
        if (!options_.mode.work.empty()) {
            install_stop_handlers();
            work_on_table(options_);
            return;
        }
        if (options_.what != "verlet1967") {
            throw InputError(fmt::format("unknown table '{}' to reproduce, allowed: verlet1967", options_.what));
        }
        install_stop_handlers();
        const fs::path out = options_.out;
        std::optional<SlurmArray> array;
        if (options_.mode.slurm) {
            array.emplace("reproduce", out, *options_.mode.slurm, until_signal());
        }
        const ReproductionPlan plan{chosen_rows(options_.rows), options_.quick};
        std::vector<RowRun> runs = row_runs(plan, out);
        require_usable(out, runs, options_.force);
        make_directory(out);
        const DirectoryLock lock(out);
        const OpenDirectory& directory = lock.directory();
        if (array) {
            array->require_none();
        }
        prepare_reproduction(plan, directory);
        if (options_.force) {
            std::ranges::for_each(runs, forget_another_run, &RowRun::run);
        }
        if (options_.mode.prepare) {
            print_prepared(reproduction_words(), out, runs.size(), options_.json);
        } else if (array) {
            submit_missing(reproduction_words(), *array, pointers_to(runs), directory,
                           {options_.jobs, options_.force, options_.json},
                           [&] { return print_rows(runs, directory, options_.json); });
        } else {
            run_all(pointers_to(runs), directory, options_.jobs, until_signal(), options_.quiet ? TellRun() : tell_row);
            throw_failures(reproduction_words(), print_rows(runs, directory, options_.json), runs.size(),
                           "the same command tries them again");
        }
    }

  private:
    ReproduceOptions options_{.what = "", .out = "runs/verlet1967"};
};

}  // namespace

std::shared_ptr<Command> reproduce_command() {
    return std::make_shared<ReproduceCommand>();
}

}  // namespace ljmd
