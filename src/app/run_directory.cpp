#include "ljmd/app/run_directory.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>
#include <xxhash.h>

#include <array>
#include <chrono>
#include <nlohmann/json.hpp>
#include <system_error>

#include "ljmd/app/results.hpp"
#include "ljmd/app/run.hpp"
#include "ljmd/app/simulation.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/data_table_csv.hpp"
#include "ljmd/io/extended_xyz_writer.hpp"
#include "ljmd/io/output_file.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr const char* failed_name = "failed.xyz";

/// Every name that a run may write. `--force` removes these and nothing else.
std::vector<std::string> output_names() {
    std::vector<std::string> names{"run.json",        "results.json",   "results.txt", "thermo.csv",
                                   "trajectory.h5md", "trajectory.xyz", "final.xyz",   failed_name};
    for (const auto& method : all_analyses()) {
        names.push_back(method.name + ".csv");
    }
    return names;
}

std::vector<fs::path> old_outputs(const fs::path& directory) {
    std::vector<fs::path> old;
    std::error_code error;
    for (const std::string& name : output_names()) {
        if (fs::exists(fs::symlink_status(directory / name, error))) {
            old.push_back(directory / name);
        }
    }
    return old;
}

std::string now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

std::string host() {
    std::array<char, 256> name{};
    return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

std::string user() {
    std::array<char, 256> name{};
    return getlogin_r(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// XXH3 (64 bits) of the deck's text and of every --set, so that two runs can be told apart.
std::string deck_hash(const Deck& deck) {
    std::string text = deck.source;
    for (const std::string& setting : deck.settings) {
        text += '\n' + setting;
    }
    return fmt::format("xxh3:{:016x}", XXH3_64bits(text.data(), text.size()));
}

std::unique_ptr<TrajectoryWriter> open_trajectory(const Deck& deck, const State& first) {
    if (!deck.trajectory) {
        return nullptr;
    }
    const std::string name = deck.trajectory->format == "h5md" ? "trajectory.h5md" : "trajectory.xyz";
    return make_trajectory_writer(deck.trajectory->format, first,
                                  {.path = deck.directory / name,
                                   .velocities = deck.trajectory->velocities,
                                   .si = deck.trajectory->si ? deck.units : std::nullopt,
                                   .creator_version = build_info().version,
                                   .author = user(),
                                   .title = deck.title});
}

}  // namespace

void check_directory(const Deck& deck, bool force) {
    const fs::path& directory = deck.directory;
    std::error_code error;
    if (fs::exists(directory, error) && !fs::is_directory(directory, error)) {
        throw InputError(fmt::format("{} exists and is not a directory. Nothing was run.", directory.string()));
    }
    const std::vector<fs::path> old = old_outputs(directory);
    if (!old.empty() && !force) {
        throw InputError(
            fmt::format("{} already holds a run ({}). Nothing was run.\n  choose another directory with --out, "
                        "or replace it with --force",
                        directory.string(), old.front().filename().string()));
    }
    if (deck.system().has("file")) {
        const fs::path start = configuration_file(deck.system().text("file"));
        for (const fs::path& file : old) {
            if (fs::equivalent(file, start, error)) {
                throw InputError(
                    fmt::format("{}, where this run starts from, is in its output directory and would be "
                                "replaced. Nothing was run.\n  choose another directory with --out",
                                start.string()));
            }
        }
    }
}

void prepare_directory(const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error) {
        throw FileError(fmt::format("cannot create the directory '{}': {}", directory.string(), error.message()));
    }
    for (const fs::path& file : old_outputs(directory)) {
        fs::remove(file, error);
        if (error) {
            throw FileError(fmt::format("cannot remove '{}': {}", file.string(), error.message()));
        }
    }
}

RunDirectory::RunDirectory(const Deck& deck, const State& first, bool order_parameter)
    : deck_(deck),
      began_(now()),
      thermo_(deck.directory / "thermo.csv", order_parameter, deck.units),
      trajectory_(open_trajectory(deck, first)) {
    write_record(false, 0.0);
}

void RunDirectory::write_thermo(Index step, double time, const Thermodynamics& row,
                                std::optional<double> order_parameter) {
    constexpr Index rows_between_flushes = 100;
    thermo_.write(step, time, row, order_parameter);
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

void RunDirectory::write_frame_if_due(const State& state) {
    if (trajectory_ && state.step % deck_.trajectory->every == 0) {
        trajectory_->write(state);
    }
}

void RunDirectory::finish(const State& state, const RunResult& result) {
    thermo_.close();
    if (trajectory_) {
        trajectory_->close();
    }
    write_configuration(deck_.directory / "final.xyz", state, true);
    for (const DataTable& table : result.tables) {
        write_file_atomically(deck_.directory / (table.name + ".csv"), to_csv(with_si_columns(table, deck_.units)));
    }
    write_file_atomically(deck_.directory / "results.json", results_json(deck_, result) + "\n");
    write_file_atomically(deck_.directory / "results.txt", results_table(deck_, result));
    write_record(true, result.seconds);
}

fs::path RunDirectory::write_failed(const State& state) const {
    const fs::path path = deck_.directory / failed_name;
    write_configuration(path, state, true);
    return path;
}

void RunDirectory::write_record(bool finished, double seconds) const {
    const BuildInfo& build = build_info();
    nlohmann::ordered_json record = {
        {"program", "ljmd"},
        {"version", build.version},
        {"commit", build.commit},
        {"compiler", build.compiler + " " + build.compiler_version},
        {"build_type", build.build_type},
        {"flags", build.flags},
        {"simd", "none (portable scalar code)"},
        {"threads", 1},
        {"host", host()},
        {"title", deck_.title},
        {"deck_file", deck_.path},
        {"deck", deck_.source},
        {"settings", deck_.settings},
        {"deck_hash", deck_hash(deck_)},
        {"seed", deck_.system().integer("seed")},
        {"units", "reduced"},
        {"began", began_},
        {"ended", finished ? nlohmann::ordered_json(now()) : nlohmann::ordered_json(nullptr)},
        {"finished", finished},
        {"seconds_in_time_loop", finished ? nlohmann::ordered_json(seconds) : nlohmann::ordered_json(nullptr)},
        {"resumed_at_steps", nlohmann::ordered_json::array()}};
    record["argon"] = nullptr;
    if (deck_.units) {
        record["argon"] = {{"sigma_nm", deck_.units->nanometre()},
                           {"epsilon_K", deck_.units->kelvin()},
                           {"mass_u", deck_.units->dalton()},
                           {"tau_ps", deck_.units->picosecond()}};
    }
    // The path of a deck need not be UTF-8, as JSON must.
    const std::string text = record.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    write_file_atomically(deck_.directory / "run.json", text + "\n");
}

}  // namespace ljmd
