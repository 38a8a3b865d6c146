#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "ljmd/app/deck.hpp"
#include "ljmd/io/thermo_csv.hpp"
#include "ljmd/io/trajectory_writer.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

struct RunResult;

/// Make the output directory of a run ready: create it, or, when it holds an earlier run, refuse, or with `force` remove
/// the files of that run (only those that ljmd writes).
/// @throws InputError  it holds a run and force is not given, or the path is not a directory; nothing is changed then
/// @throws FileError   it cannot be created or cleared
void prepare_directory(const std::filesystem::path& directory, bool force);

/// The files of a run while it goes. See docs/files.md for what each holds.
class RunDirectory {
  public:
    /// Writes run.json and opens the others. @throws FileError
    RunDirectory(const Deck& deck, const State& first, bool order_parameter);

    void write_thermo(Index step, double time, const Thermodynamics& row, std::optional<double> order_parameter);
    void write_frame(const State& state);
    void write_frame_if_due(const State& state);

    /// Closes the outputs and writes final.xyz, the analyses' tables, results.json, and run.json once more.
    void finish(const State& state, const RunResult& result);

  private:
    void write_record(bool finished, double seconds) const;

    const Deck& deck_;
    std::string began_;
    ThermoCsv thermo_;
    std::unique_ptr<TrajectoryWriter> trajectory_;
    Index rows_since_flush_ = 0;
};

}  // namespace ljmd
