#include "study/row_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/files/directory_lock.hpp"
#include "io/files/file_system.hpp"
#include "io/files/replacement_file.hpp"
#include "io/tables/json_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr const char* record_name = "reproduction.json";
constexpr const char* table_name = "verlet1967";

std::string record_text(const ReproductionPlan& plan) {
    Data rows = Data::list();
    for (const VerletRow& row : plan.rows) {
        rows.push_back(row_name(row));
    }
    return to_json({{"program", "ljmd"}, {"table", table_name}, {"quick", plan.quick}, {"rows", rows}}) + "\n";
}

}  // namespace

RowRun::RowRun(const VerletRow& row, const fs::path& folder, const ReproductionLength& length)
    : row_(row),
      length_(length),
      run_{.name = row_name(row),
           .deck = folder / deck_name(row),
           .source = row_deck(row, length),
           .directory = folder / row_name(row),
           .log = folder / (row_name(row) + ".log")} {}

std::optional<Job> RowRun::first_job() {
    auto job = ljmd::next_job(run_);
    return job ? job : next_job();
}

std::optional<Job> RowRun::next_job() {
    result_ = evaluate_row(row_, run_.directory);
    return result_->precise(length_) ? std::nullopt : std::optional(longer(run_, length_.production));
}

void RowRun::check(bool force) const {
    check_places(run_);
    if (!force && holds_another_run(run_)) {
        throw InputError(
            fmt::format("{} holds a run of another length or version; --force makes it anew", run_.directory.string()));
    }
}

void RowRun::prepare(const OpenDirectory& folder) const {
    write_file_atomically(folder / deck_name(row_), run_.source);
}

std::vector<RowRun> row_runs(const ReproductionPlan& plan, const fs::path& directory) {
    std::vector<RowRun> runs;
    runs.reserve(plan.rows.size());
    for (const VerletRow& row : plan.rows) {
        runs.emplace_back(row, directory / rows_folder, plan.length());
    }
    return runs;
}

void prepare_reproduction(const ReproductionPlan& plan, const OpenDirectory& directory) {
    const OpenDirectory folder = directory.made_within(rows_folder);
    const auto recorded = recorded_reproduction(directory.path());
    std::optional<DirectoryLock> workers_away;
    if (recorded && record_text(*recorded) != record_text(plan)) {
        workers_away.emplace(folder);
    }
    remove_left_over(folder);
    for (const RowRun& run : row_runs(plan, directory.path())) {
        run.prepare(folder);
    }
    write_file_atomically(directory / record_name, record_text(plan));
}

std::optional<ReproductionPlan> recorded_reproduction(const fs::path& directory) {
    const fs::path path = directory / record_name;
    if (!files::is_taken(path)) {
        return std::nullopt;
    }
    return read_json(path, "the record of a reproduced table", [](const Data& record) {
        if (record.at("table") != table_name) {
            throw WrongData("its table is not known");
        }
        ReproductionPlan plan{{}, record.at("quick").flag()};
        const std::vector<VerletRow>& table = verlet1967_table();
        for (const std::string& name : texts_of(record.at("rows"), "rows", table.size())) {
            const auto row = std::ranges::find(table, name, row_name);
            if (row == table.end()) {
                throw WrongData("the table has not all of its rows");
            }
            plan.rows.push_back(*row);
        }
        return plan;
    });
}

}  // namespace ljmd
