#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/document.hpp"
#include "engine/few_body_system.hpp"
#include "engine/fluid_system.hpp"
#include "io/tables/few_body_csv.hpp"
#include "io/tables/thermo_csv.hpp"
#include "ljmd/detail/engine/phase_seconds.hpp"
#include "ljmd/detail/engine/run_outputs.hpp"
#include "ljmd/detail/model/state.hpp"
#include "run/continuation.hpp"
#include "run/run_record.hpp"

namespace ljmd {

/// The configuration that a run was given to start from, if it did not read one.
inline constexpr const char* given_start_name = "given-start.xyz";

/// The page about a run in its directory, which `ljmd report` writes.
inline constexpr const char* report_name = "report.html";

/// All names that a run may write into its directory. `--force` replaces only these.
[[nodiscard]] std::vector<std::string> run_output_names();

/// Refuse an output directory that cannot be used. Changes nothing.
/// @param force  accept files of an earlier run in it
/// @throws OutputRefused  it holds a run and force is not set, it cannot be written to (existing_outputs), or a file
/// that the run reads is one of those that it would replace
void check_directory(const RunPlan& plan, bool force);

/// Refuse outputs that are also inputs: the deck, and the file it starts from.
/// @param consequence  what was not done, for the message: "Nothing was run"
/// @throws OutputRefused
void require_no_input(const RunPlan& plan, const std::vector<std::filesystem::path>& outputs,
                      const std::string& consequence);

/// Create a directory and its parents, if they are missing, and synchronise their names. @throws FileError
void make_directory(const std::filesystem::path& directory);

/// Prepare the output directory of a run: create it, and remove the files of an earlier run (only those that ljmd
/// writes).
/// @pre  check_directory accepted it
/// @throws FileError  it cannot be created or cleared
void prepare_directory(const std::filesystem::path& directory);

/// Refuse files that cannot be the run's, as far as this shows without reading them. Called before any of them
/// is changed. @throws CheckpointError
void check_outputs(const RunPlan& plan, const Continuation& continuation);

/// What a run writes at its end.
struct FinalOutputs {
    Document report = {};  ///< results.json and results.txt
    std::vector<DataTable> tables = {};
    double seconds = 0.0;                     ///< wall time of the time loop
    std::optional<PhaseSeconds> phases = {};  ///< its parts, if measured
    std::optional<UntilEnd> until = {};       ///< of a run that was to reach errors
};

/// The output files of a running run; docs/files.md describes them.
class RunDirectory {
  public:
    /// Opens the outputs and writes run.json.
    /// @param continuation  continue the files of an interrupted run  @throws FileError, CheckpointError
    RunDirectory(const RunPlan& plan, const FluidSystem& fluid, const std::optional<Continuation>& continuation = {});
    RunDirectory(const RunPlan& plan, const FewBodySystem& system,
                 const std::optional<Continuation>& continuation = {});

    /// @pre the row is one of the kind of system that the directory was opened for
    void write(const ThermoRow& row);
    void write(const FewBodyRow& row);

    /// Write a frame of the trajectory, if the deck has one. @param angle  see RunOutputs::frame
    void write_frame(const State& state, const std::optional<double>& angle = {});
    [[nodiscard]] bool frame_is_due(const State& state) const;

    /// Synchronise everything written. @return how much that is  @throws FileError
    CommittedOutputs commit();

    /// Close the outputs; write final.xyz, the tables of the analyses, results.json and .txt, and run.json again.
    void finish(const State& state, const FinalOutputs& outputs);

  private:
    void row_written();

    const RunPlan& plan_;
    std::optional<TrajectoryCsv> csv_;
    std::optional<PairPotential> energies_of_;      ///< set: frames hold the energies of the atoms in this potential
    std::unique_ptr<TrajectoryWriter> trajectory_;  ///< if it is not CSV; may throw when the run is resumed
    std::variant<ThermoCsv, FewBodyThermoCsv> thermo_;
    RunRecord record_;
    Index rows_since_flush_ = 0;
};

}  // namespace ljmd
