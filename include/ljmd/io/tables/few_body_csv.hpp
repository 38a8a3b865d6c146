#pragma once

#include <filesystem>
#include <optional>

#include "ljmd/io/files/output_file.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/observables/few_body/few_body.hpp"

namespace ljmd {

/// The history of a few-body run as CSV, one row per sample: step, time, potential_energy, kinetic_energy,
/// total_energy, momentum_x (momentum_y, momentum_z in two and three dimensions), then angular_momentum_z in two
/// dimensions, all three components in three.
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
    int dimensions_;
};

/// The trajectories of a few bodies as CSV, one row per time: step, time, then for each body its position (x1, y1, z1),
/// velocity (vx1, ...) and, if asked for, acceleration (ax1, ...), with as many components as there are dimensions;
/// last, if the force has one, the polar angle that belongs to the coordinate.
class TrajectoryCsv {
  public:
    /// @param kept  bytes of a file to continue; none: a new file  @throws FileError, CheckpointError
    TrajectoryCsv(const OutputPlace& place, Index bodies, int dimensions, bool accelerations, bool angle,
                  std::optional<std::int64_t> kept = std::nullopt);

    /// @pre forces are current if accelerations are written; an angle is given if the file has that column
    /// @throws FileError
    void write(const State& state, std::optional<double> angle);

    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// Synchronise what was written so far: it survives a power cut. @return length of the file in bytes
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    int dimensions_;
    bool accelerations_;
    bool angle_;
};

}  // namespace ljmd
