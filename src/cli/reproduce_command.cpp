#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/signals.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/io/files/directory_lock.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/io/files/replacement_file.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "ljmd/run/output_guard.hpp"
#include "ljmd/run/run_directory.hpp"
#include "ljmd/study/child_run.hpp"
#include "ljmd/study/reproduction_report.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

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

/// A row of the table being computed: a deck, a directory, and runs that follow one another.
class RowRun {
  public:
    RowRun(const VerletRow& row, const fs::path& folder, const ReproductionLength& length)
        : row_(row),
          length_(length),
          run_{.name = row_name(row),
               .deck = folder / deck_name(row),
               .source = row_deck(row, length),
               .directory = folder / row_name(row),
               .log = folder / (row_name(row) + ".log")} {}

    [[nodiscard]] static std::string deck_name(const VerletRow& row) { return row_name(row) + ".toml"; }

    [[nodiscard]] const std::optional<ReproducedRow>& result() const { return result_; }
    [[nodiscard]] const std::string& failure() const { return failure_; }

    /// Refuse a directory with a run of another deck. @throws InputError
    void check(bool force) const {
        check_places(run_);
        if (!force && holds_another_run(run_)) {
            throw InputError(fmt::format("{} holds a run of another length or version; --force makes it anew",
                                         run_.directory.string()));
        }
    }

    /// Write the deck. @param folder  of all rows
    void prepare(const OpenDirectory& folder) const { write_file_atomically(folder / deck_name(row_), run_.source); }

    /// The first job; nothing if the row is finished.
    std::optional<Job> begin() {
        const auto job = next_job(run_);
        return job ? job : after(0);
    }

    /// The next job after one has ended; nothing if the row is finished or has failed.
    std::optional<Job> after(int exit_status) {
        if (exit_status != 0) {
            failure_ = failure_of(run_, exit_status);
            return std::nullopt;
        }
        result_ = evaluate_row(row_, run_.directory);
        return result_->precise(length_) ? std::nullopt : std::optional(longer(run_, length_.production));
    }

  private:
    VerletRow row_;
    ReproductionLength length_;
    ChildRun run_;
    std::optional<ReproducedRow> result_;
    std::string failure_;
};

const std::string rows_folder = "rows";

/// Refuse a directory whose files are not those of a reproduced table. @throws InputError
void require_usable(const fs::path& out, bool force) {
    const std::string consequence = "Nothing was run";
    require_no_run(out, consequence);
    const bool begun = std::ranges::any_of(verlet1967_table(), [&](const VerletRow& row) {
        return files::exists(out / rows_folder / RowRun::deck_name(row));
    });
    require_no_outputs(out, {"rows.csv", "isotherms.csv", "rows.md", "results.json"}, begun || force, consequence);
}

void tell(const RowRun& run, std::size_t done, std::size_t all) {
    const auto& [verlet, steps, temperature, z, u, beyond, thol, kolafa] = *run.result();
    print_message(fmt::format("[{}/{}] rho {} T {}: Z {:.3f} +- {:.3f}, U {:.4f} +- {:.4f} in {} steps\n", done, all,
                              verlet.density, verlet.temperature, z.mean, z.standard_error, u.mean, u.standard_error,
                              steps));
}

}  // namespace

void reproduce_command(const ReproduceOptions& options) {
    if (options.what != "verlet1967") {
        throw InputError(fmt::format("unknown table '{}' to reproduce, allowed: verlet1967", options.what));
    }
    install_stop_handlers();
    const ReproductionLength length = options.quick ? ReproductionLength::quick() : ReproductionLength::full();
    const fs::path out = options.out;
    require_usable(out, options.force);
    std::vector<RowRun> runs;
    for (const VerletRow& row : chosen_rows(options.rows)) {
        runs.emplace_back(row, out / rows_folder, length).check(options.force);
    }
    make_directory(out);
    const DirectoryLock lock(out);
    const OpenDirectory& directory = lock.directory();
    const OpenDirectory folder = directory.made_within(rows_folder);
    wait_for_runs(folder.path(), until_signal(), print_message);
    remove_left_over(folder);
    for (const RowRun& run : runs) {
        run.prepare(folder);
    }

    run_lines(runs, options.jobs, until_signal(), [&](const RowRun& run, std::size_t done) {
        directory.require_at_its_path();  // runs are started by path
        if (!run.failure().empty()) {
            warn(run.failure());
        } else if (!options.quiet) {
            tell(run, done, runs.size());
        }
    });

    std::vector<ReproducedRow> rows;
    for (const RowRun& run : runs) {
        if (run.failure().empty()) {
            rows.push_back(*run.result());
        }
    }
    directory.require_at_its_path();
    write_file_atomically(directory / "rows.csv", reproduction_csv(rows));
    write_file_atomically(directory / "isotherms.csv", isotherms_csv());
    write_file_atomically(directory / "rows.md", reproduction_markdown(rows));
    Document report = reproduction_report(rows, result_columns());
    write_file_atomically(directory / "results.json", to_json(report.data) + "\n");
    report.text += fmt::format("\nfiles: {0}\nto draw them: ljmd plot {0}\n", out.string());
    print_document(report, options.json);
    if (rows.size() < runs.size()) {
        throw PhysicsError(fmt::format("{} of {} rows failed; the same command tries them again",
                                       runs.size() - rows.size(), runs.size()));
    }
}

}  // namespace ljmd
