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

/// The files of a few-body run while it goes. See docs/files.md for what each holds.
class FewBodyDirectory {
  public:
    /// Opens the outputs and writes run.json.
    /// @param resumed  go on with the files of an earlier part of the run  @throws FileError, CheckpointError
    FewBodyDirectory(const Deck& deck, const FewBodySystem& system,
                     const std::optional<ResumedOutputs>& resumed = std::nullopt);

    void write_thermo(const State& state, const FewBodyTotals& totals);

    /// A frame of the trajectory, if the deck has one.
    void write_frame(const State& state, const std::optional<PolarAngle>& angle);

    /// All that was written is on the disk. @return how much that is  @throws FileError
    CommittedOutputs commit();

    /// Closes the outputs and writes final.xyz, the analyses' tables, results.json and .txt, and run.json once more.
    void finish(const State& state, const FewBodyResult& result, const std::vector<DataTable>& tables);

  private:
    const Deck& deck_;
    std::optional<TrajectoryCsv> csv_;
    std::unique_ptr<TrajectoryWriter> trajectory_;  ///< where it is not CSV; it may refuse to go on
    FewBodyThermoCsv thermo_;
    RunRecord record_;
    Index rows_since_flush_ = 0;
};

}  // namespace ljmd
