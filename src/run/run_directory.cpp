#include "ljmd/run/run_directory.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ljmd/core/errors.hpp"
#include "ljmd/deck/simulation.hpp"
#include "ljmd/io/files/checkpoint_file.hpp"
#include "ljmd/io/files/file_system.hpp"
#include "ljmd/io/files/replacement_file.hpp"
#include "ljmd/io/formats/extended_xyz_writer.hpp"
#include "ljmd/io/tables/data_table_csv.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"
#include "ljmd/run/output_guard.hpp"
#include "ljmd/run/results.hpp"
#include "ljmd/run/run.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

ThermoCsv::Extra thermo_columns(const Deck& deck, bool order_parameter) {
    const auto any = [&](const auto& wanted) { return std::ranges::any_of(deck.stages, wanted); };
    return {.density = any([](const Stage& stage) { return stage.barostat.has_value(); }),
            .conserved_energy = any([](const Stage& stage) { return stage.thermostat && conserves_energy(stage); }),
            .order_parameter = order_parameter};
}

}  // namespace

std::vector<std::string> run_output_names() {
    std::vector<std::string> names{"run.json",       "results.json",   "results.txt", "thermo.csv", "trajectory.h5md",
                                   "trajectory.xyz", "trajectory.csv", "final.xyz",   "failed.xyz"};
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
    return names;
}

void check_directory(const Deck& deck, bool force) {
    const fs::path& directory = deck.directory;
    const std::vector<fs::path> old = existing_outputs(directory, run_output_names(), "Nothing was run");
    if (!old.empty() && !force) {
        const std::vector<std::string> checkpoints = checkpoint_names();
        const bool can_go_on = std::any_of(old.begin(), old.end(), [&](const fs::path& file) {
            return std::find(checkpoints.begin(), checkpoints.end(), file.filename()) != checkpoints.end();
        });
        throw InputError(
            fmt::format("{0} already holds a run ({1}). Nothing was run.\n  choose another directory with --out, "
                        "or replace it with --force{2}",
                        directory.string(), old.front().filename().string(),
                        can_go_on ? fmt::format(", or go on with it: ljmd resume {}", directory.string()) : ""));
    }
    require_no_input(deck, old, "Nothing was run");
}

void require_no_input(const Deck& deck, const std::vector<fs::path>& outputs, const std::string& consequence) {
    std::vector<fs::path> inputs{deck.path};
    if (deck.kind == DeckKind::fluid && deck.system().has("file")) {
        inputs.push_back(configuration_file(deck.system().text("file")));
    }
    for (const fs::path& input : inputs) {
        for (const fs::path& output : outputs) {
            if (files::are_same(output, input)) {
                throw InputError(
                    fmt::format("{} is read, and would be replaced by what is written. {}.\n  choose another "
                                "directory with --out",
                                input.string(), consequence));
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

void check_outputs(const Deck& deck, const ResumedOutputs& resumed) {
    require_bytes(deck.outputs() / "thermo.csv", resumed.kept.thermo);
    if (deck.trajectory) {
        require_bytes(deck.outputs() / fmt::format("trajectory.{}", deck.trajectory->format),
                      resumed.kept.trajectory.bytes);
    }
}

RunDirectory::RunDirectory(const Deck& deck, const State& first, bool order_parameter,
                           const std::optional<ResumedOutputs>& resumed)
    : deck_(deck),
      trajectory_(open_trajectory(deck, first, resumed ? std::optional(resumed->kept.trajectory) : std::nullopt)),
      thermo_(deck.outputs() / "thermo.csv", thermo_columns(deck, order_parameter), deck.units,
              resumed ? std::optional(resumed->kept.thermo) : std::nullopt),
      record_(deck, resumed ? std::optional(resumed->earlier) : std::nullopt) {}

CommittedOutputs RunDirectory::commit() {
    return {thermo_.commit(), trajectory_ ? trajectory_->commit() : CommittedFrames()};
}

void RunDirectory::write_thermo(Index step, double time, const Thermodynamics& row, const ThermoCsv::Values& values) {
    constexpr Index rows_between_flushes = 100;
    thermo_.write(step, time, row, values);
    if (++rows_since_flush_ == rows_between_flushes) {
        thermo_.flush();
        rows_since_flush_ = 0;
    }
}

void RunDirectory::write_frame(const State& state) {
    if (trajectory_) {
        trajectory_->write(state);
    }
}

bool RunDirectory::frame_is_due(const State& state) const {
    return trajectory_ && state.step % deck_.trajectory->every == 0;
}

void RunDirectory::finish(const State& state, const RunResult& result) {
    thermo_.close();
    if (trajectory_) {
        trajectory_->close();
    }
    write_configuration(deck_.outputs() / "final.xyz", state, true);
    for (const DataTable& table : result.tables) {
        write_file_atomically(deck_.outputs() / (table.name + ".csv"), to_csv(with_si_columns(table, deck_.units)));
    }
    write_file_atomically(deck_.outputs() / "results.json", results_json(deck_, result) + "\n");
    write_file_atomically(deck_.outputs() / "results.txt", results_table(deck_, result));
    record_.finish(result.seconds.sum(), result.seconds);
}

}  // namespace ljmd
