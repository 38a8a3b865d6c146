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

/// All names that a run may write into its directory. `--force` replaces only these.
[[nodiscard]] std::vector<std::string> run_output_names();

/// Refuse an output directory that cannot be used. Changes nothing.
/// @param force  accept files of an earlier run in it
/// @throws InputError  it holds a run and force is not set, it cannot be written to (existing_outputs), or a file that
/// the run reads is one of those that it would replace
void check_directory(const Deck& deck, bool force);

/// Refuse outputs that are also inputs: the deck, and the file it starts from.
/// @param consequence  what was not done, for the message: "Nothing was run"
/// @throws InputError
void require_no_input(const Deck& deck, const std::vector<std::filesystem::path>& outputs,
                      const std::string& consequence);

/// Create a directory and its parents, if they are missing, and synchronise their names. @throws FileError
void make_directory(const std::filesystem::path& directory);

/// Prepare the output directory of a run: create it, and remove the files of an earlier run (only those that ljmd
/// writes).
/// @pre  check_directory accepted it
/// @throws FileError  it cannot be created or cleared
void prepare_directory(const std::filesystem::path& directory);

/// The state of the output files of a resumed run.
struct ResumedOutputs {
    CommittedOutputs kept;
    EarlierParts earlier;
};

/// Refuse files that cannot be those of the run, as far as this shows without reading them. Called before any of them
/// is changed. @throws CheckpointError
void check_outputs(const Deck& deck, const ResumedOutputs& resumed);

/// The output files of a running fluid run; docs/files.md describes them.
class RunDirectory {
  public:
    /// Opens the outputs and writes run.json.
    /// @param resumed  continue the files of an interrupted run  @throws FileError, CheckpointError
    RunDirectory(const Deck& deck, const State& first, bool order_parameter,
                 const std::optional<ResumedOutputs>& resumed = std::nullopt);

    void write_thermo(Index step, double time, const Thermodynamics& row, const ThermoCsv::Values& values);
    void write_frame(const State& state);
    [[nodiscard]] bool frame_is_due(const State& state) const;

    /// Synchronise everything written. @return how much that is  @throws FileError
    CommittedOutputs commit();

    /// Close the outputs; write final.xyz, the tables of the analyses, results.json and .txt, and run.json again.
    void finish(const State& state, const RunResult& result);

  private:
    const Deck& deck_;
    std::unique_ptr<TrajectoryWriter> trajectory_;  ///< opened first: it may throw when the run is resumed
    ThermoCsv thermo_;
    RunRecord record_;
    Index rows_since_flush_ = 0;
};

}  // namespace ljmd
