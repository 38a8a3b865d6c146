#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/io/tables/thermo_csv.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/run/run_checkpoints.hpp"
#include "ljmd/run/run_record.hpp"

namespace ljmd {

struct RunResult;

/// Every name that a run may write into its directory. `--force` replaces these and nothing else.
[[nodiscard]] std::vector<std::string> run_output_names();

/// Refuse an output directory that cannot be used. Changes nothing.
/// @param force  files of an earlier run in it are no reason to refuse
/// @throws InputError  it holds a run and force is not given, it cannot be written to (existing_outputs), or a file
/// that
///                     the run reads is one of those that it would replace
void check_directory(const Deck& deck, bool force);

/// Refuse outputs that are what is read: the deck, and the file that it starts from.
/// @param consequence  what was not done therefore: "Nothing was run"
/// @throws InputError
void require_no_input(const Deck& deck, const std::vector<std::filesystem::path>& outputs,
                      const std::string& consequence);

/// Create a directory and those above it, if they are not there; their names are on the disk then. @throws FileError
void make_directory(const std::filesystem::path& directory);

/// Make the output directory of a run ready: create it, and remove the files of an earlier run (only those that ljmd
/// writes).
/// @pre  check_directory accepted it
/// @throws FileError  it cannot be created or cleared
void prepare_directory(const std::filesystem::path& directory);

/// What the files of a run have been so far.
struct ResumedOutputs {
    CommittedOutputs kept;
    EarlierParts earlier;
};

/// Refuse files that are not what the run left, where that can be seen without reading them: before one of them is
/// changed. @throws CheckpointError
void check_outputs(const Deck& deck, const ResumedOutputs& resumed);

/// The files of a run while it goes. See docs/files.md for what each holds.
class RunDirectory {
  public:
    /// Opens the outputs and writes run.json.
    /// @param resumed  go on with the files of an earlier part of the run  @throws FileError, CheckpointError
    RunDirectory(const Deck& deck, const State& first, bool order_parameter,
                 const std::optional<ResumedOutputs>& resumed = std::nullopt);

    void write_thermo(Index step, double time, const Thermodynamics& row, const ThermoCsv::Values& values);
    void write_frame(const State& state);
    [[nodiscard]] bool frame_is_due(const State& state) const;

    /// All that was written is on the disk. @return how much that is  @throws FileError
    CommittedOutputs commit();

    /// Closes the outputs and writes final.xyz, the analyses' tables, results.json and .txt, and run.json once more.
    void finish(const State& state, const RunResult& result);

  private:
    const Deck& deck_;
    std::unique_ptr<TrajectoryWriter> trajectory_;  ///< opened first: it may refuse to go on
    ThermoCsv thermo_;
    RunRecord record_;
    Index rows_since_flush_ = 0;
};

}  // namespace ljmd
