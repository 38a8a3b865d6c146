#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ljmd/deck/few_body.hpp"
#include "ljmd/io/formats/trajectory_writer.hpp"
#include "ljmd/io/tables/few_body_csv.hpp"
#include "ljmd/run/run_directory.hpp"

namespace ljmd {

struct FewBodyResult;

/// The output files of a running few-body run; docs/files.md describes them.
class FewBodyDirectory {
  public:
    /// Opens the outputs and writes run.json.
    /// @param resumed  continue the files of an interrupted run  @throws FileError, CheckpointError
    FewBodyDirectory(const Deck& deck, const FewBodySystem& system,
                     const std::optional<ResumedOutputs>& resumed = std::nullopt);

    void write_thermo(const State& state, const FewBodyTotals& totals);

    /// Write a frame of the trajectory, if the deck has one.
    void write_frame(const State& state, const std::optional<PolarAngle>& angle);

    /// Synchronise everything written. @return how much that is  @throws FileError
    CommittedOutputs commit();

    /// Close the outputs; write final.xyz, the tables of the analyses, results.json and .txt, and run.json again.
    void finish(const State& state, const FewBodyResult& result, const std::vector<DataTable>& tables);

  private:
    const Deck& deck_;
    std::optional<TrajectoryCsv> csv_;
    std::unique_ptr<TrajectoryWriter> trajectory_;  ///< if it is not CSV; may throw when the run is resumed
    FewBodyThermoCsv thermo_;
    RunRecord record_;
    Index rows_since_flush_ = 0;
};

}  // namespace ljmd
