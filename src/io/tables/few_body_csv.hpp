#pragma once

#include <cstdint>
#include <optional>

#include "io/files/output_file.hpp"
#include "io/tables/few_body_columns.hpp"

namespace ljmd {

/// The history of a few-body run as CSV, one row per sample, with the columns of FewBodyThermoColumns.
class FewBodyThermoCsv {
  public:
    /// @param kept  bytes of a file to continue; none: a new file  @throws FileError, CheckpointError
    FewBodyThermoCsv(const OutputPlace& place, int dimensions, std::optional<std::int64_t> kept = std::nullopt);

    /// @throws FileError
    void write(Index step, double time, const FewBodyTotals& totals);

    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// Synchronise what was written so far: it survives a power cut. @return length of the file in bytes
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    FewBodyThermoColumns columns_;
};

/// The trajectories of a few bodies as CSV, one row per time, with the columns of TrajectoryColumns.
class TrajectoryCsv {
  public:
    /// @param kept  bytes of a file to continue; none: a new file  @throws FileError, CheckpointError
    TrajectoryCsv(const OutputPlace& place, const TrajectoryColumns& columns,
                  std::optional<std::int64_t> kept = std::nullopt);

    /// @pre as TrajectoryColumns::row()  @throws FileError
    void write(const State& state, std::optional<double> angle);

    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// Synchronise what was written so far: it survives a power cut. @return length of the file in bytes
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    TrajectoryColumns columns_;
};

}  // namespace ljmd
