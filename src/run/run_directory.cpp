#include "run/run_directory.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/deck_system.hpp"
#include "deck/history_columns.hpp"
#include "forces/atom_energies.hpp"
#include "io/files/checkpoint_file.hpp"
#include "io/files/file_system.hpp"
#include "io/files/replacement_file.hpp"
#include "io/files/shell_word.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "io/tables/data_table_csv.hpp"
#include "io/tables/json_file.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "model/atoms_by_id.hpp"
#include "observables/few_body/few_body_analysis.hpp"
#include "run/given/given_record.hpp"
#include "run/output_guard.hpp"
#include "run/results.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

std::optional<TrajectoryCsv> open_csv(const RunPlan& plan, const FewBodySystem& system,
                                      const std::optional<Continuation>& continuation) {
    if (!plan.trajectory || plan.trajectory->format != "csv") {
        return std::nullopt;
    }
    const auto frames = kept(continuation, &CommittedOutputs::trajectory);
    return TrajectoryCsv(plan.outputs() / "trajectory.csv", trajectory_columns(plan, system),
                         frames ? std::optional(frames->bytes) : std::nullopt);
}

std::vector<double> energies_by_id(const State& state, const PairPotential& potential) {
    return state.execution().ranks().alone() ? atom_energies(state, potential)
                                             : atom_energies(gathered_for_root(state), potential);
}

/// Whether the record of a run says that it has come to its end. True where it cannot be read: nothing is known then.
bool has_finished(const fs::path& directory) {
    try {
        return read_json(directory / "run.json", "the record of a run",
                         [](const Data& record) { return record.at("finished").flag(); });
    } catch (const Error&) {
        return true;
    }
}

}  // namespace

std::vector<std::string> run_output_names() {
    std::vector<std::string> names{"run.json", "results.json", "results.txt", "thermo.csv"};
    for (const auto& format : all_trajectory_formats()) {
        names.push_back("trajectory." + format.name);
    }
    names.insert(names.end(), {"trajectory.csv", "final.xyz", "failed.xyz", given_start_name, pair_table_name});
    for (const std::string& name : checkpoint_names()) {
        names.push_back(name);
    }
    for (const auto& method : all_analyses()) {
        for (const std::string& file : method.files) {
            names.push_back(file + ".csv");
        }
    }
    for (const auto& method : all_few_body_analyses()) {
        names.push_back(method.name + ".csv");
    }
    names.emplace_back(report_name);
    return names;
}

void check_directory(const RunPlan& plan, bool force) {
    const fs::path& directory = plan.directory;
    const std::vector<fs::path> old = existing_outputs(directory, run_output_names(), "Nothing was run");
    if (!old.empty() && !force) {
        const std::vector<std::string> checkpoints = checkpoint_names();
        const bool can_resume = std::any_of(old.begin(), old.end(), [&](const fs::path& file) {
            return std::find(checkpoints.begin(), checkpoints.end(), file.filename()) != checkpoints.end();
        });
        const std::string resume = fmt::format(": ljmd resume {}", shell_word(directory));
        if (can_resume && !has_finished(directory)) {
            throw OutputRefused(
                fmt::format("{} holds a run that has not come to its end. Nothing was run.", directory.string()),
                {{"resume it", resume},
                 {"or choose another directory", " with --out"},
                 {"or replace it", " with --force"}});
        }
        OutputRefused::Choices choices{another_directory, {"or replace it", " with --force"}};
        if (can_resume) {
            choices.emplace_back("or resume it", resume);
        }
        throw OutputRefused(fmt::format("{} already holds a run ({}). Nothing was run.", directory.string(),
                                        old.front().filename().string()),
                            choices);
    }
    require_no_input(plan, old, "Nothing was run");
}

void require_no_input(const RunPlan& plan, const std::vector<fs::path>& outputs, const std::string& consequence) {
    std::vector<fs::path> inputs{plan.path};
    if (plan.start_file) {
        inputs.push_back(*plan.start_file);
    }
    for (const fs::path& input : inputs) {
        for (const fs::path& output : outputs) {
            if (files::are_same(output, input)) {
                throw OutputRefused(fmt::format("{} is read, and would be replaced by what is written. {}.",
                                                input.string(), consequence),
                                    {another_directory});
            }
        }
    }
}

void make_directory(const fs::path& directory) {
    std::vector<fs::path> made;
    for (fs::path folder = directory; !folder.empty() && !files::exists(folder); folder = folder.parent_path()) {
        made.push_back(folder);
    }
    files::create_directories(directory);
    for (const fs::path& folder : made) {
        OpenDirectory(folder.parent_path()).sync();
    }
}

void prepare_directory(const fs::path& directory) {
    make_directory(directory);
    for (const fs::path& file : existing_outputs(directory, run_output_names(), "Nothing was removed")) {
        files::remove(file);
    }
}

void check_outputs(const RunPlan& plan, const Continuation& continuation) {
    const CommittedOutputs& outputs = continuation.head.outputs;
    require_bytes(plan.outputs() / "thermo.csv", outputs.thermo);
    if (plan.trajectory) {
        require_bytes(plan.outputs() / fmt::format("trajectory.{}", plan.trajectory->format), outputs.trajectory.bytes);
    }
}

RunDirectory::RunDirectory(const RunPlan& plan, const FluidSystem& fluid,
                           const std::optional<Continuation>& continuation)
    : plan_(plan),
      energies_of_(plan.trajectory && plan.trajectory->energies ? std::optional(fluid.force_field.potential())
                                                                : std::nullopt),
      trajectory_(open_trajectory(plan, fluid.state, continuation)),
      thermo_(std::in_place_type<ThermoCsv>, plan.outputs() / "thermo.csv",
              thermo_columns(plan, fluid.order.has_value(), fluid.force_field.external().get()),
              kept(continuation, &CommittedOutputs::thermo)),
      record_(plan, fluid.state.execution(), continuation) {}

RunDirectory::RunDirectory(const RunPlan& plan, const FewBodySystem& system,
                           const std::optional<Continuation>& continuation)
    : plan_(plan),
      csv_(open_csv(plan, system, continuation)),
      trajectory_(csv_ ? nullptr : open_trajectory(plan, system.state, continuation)),
      thermo_(std::in_place_type<FewBodyThermoCsv>, plan.outputs() / "thermo.csv", system.dimensions,
              kept(continuation, &CommittedOutputs::thermo)),
      record_(plan, system.state.execution(), continuation) {}

CommittedOutputs RunDirectory::commit() {
    const std::int64_t rows = std::visit([](auto& thermo) { return thermo.commit(); }, thermo_);
    if (csv_) {
        return {rows, {.bytes = csv_->commit()}};
    }
    return {rows, trajectory_ ? trajectory_->commit() : CommittedFrames()};
}

void RunDirectory::write(const ThermoRow& row) {
    std::get<ThermoCsv>(thermo_).write(row.step, row.time, row.values, {row.conserved_energy, row.order});
    row_written();
}

void RunDirectory::write(const FewBodyRow& row) {
    std::get<FewBodyThermoCsv>(thermo_).write(row.step, row.time, row.values);
    row_written();
}

void RunDirectory::row_written() {
    constexpr Index rows_between_flushes = 100;
    if (++rows_since_flush_ < rows_between_flushes) {
        return;
    }
    rows_since_flush_ = 0;
    std::visit([](auto& thermo) { thermo.flush(); }, thermo_);
    if (csv_) {
        csv_->flush();
    }
}

void RunDirectory::write_frame(const State& state, const std::optional<double>& angle) {
    if (csv_) {
        csv_->write(state, angle);
    } else if (trajectory_) {
        trajectory_->write(state, energies_of_ ? energies_by_id(state, *energies_of_) : std::vector<double>());
    }
}

bool RunDirectory::frame_is_due(const State& state) const {
    return plan_.trajectory && state.step % plan_.trajectory->every == 0;
}

void RunDirectory::finish(const State& state, const FinalOutputs& outputs) {
    std::visit([](auto& thermo) { thermo.close(); }, thermo_);
    if (csv_) {
        csv_->close();
    }
    if (trajectory_) {
        trajectory_->close();
    }
    write_configuration(plan_.outputs() / "final.xyz", state, true);
    for (const DataTable& table : outputs.tables) {
        write_file_atomically(plan_.outputs() / (table.name + ".csv"), to_csv(with_si_columns(table, plan_.units())));
    }
    write_file_atomically(plan_.outputs() / "results.json", to_json(outputs.report.data) + "\n");
    write_file_atomically(plan_.outputs() / "results.txt", outputs.report.text);
    record_.finish(outputs.seconds, outputs.phases, outputs.until);
}

}  // namespace ljmd
