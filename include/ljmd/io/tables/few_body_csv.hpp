#pragma once

#include <filesystem>
#include <optional>

#include "ljmd/io/files/output_file.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// Energies and momenta of a few-body system at one time, totals of all bodies, in the deck's units.
struct FewBodyTotals {
    double potential_energy;
    double kinetic_energy;
    double total_energy;
    Vec3 momentum;
    Vec3 angular_momentum;  ///< about the origin
};

/// The history of a few-body run, one row a sample, as CSV: step, time, potential_energy, kinetic_energy, total_energy,
/// momentum_x (momentum_y, momentum_z in two and three dimensions), angular_momentum_z in two, all three in three.
class FewBodyThermoCsv {
  public:
    /// @param kept  bytes of a file to go on with; none: a new one  @throws FileError, CheckpointError
    FewBodyThermoCsv(const OutputPlace& place, int dimensions, std::optional<std::int64_t> kept = std::nullopt);

    /// @throws FileError
    void write(Index step, double time, const FewBodyTotals& totals);

    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// What was written so far survives a power cut. @return bytes of it
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    int dimensions_;
};

/// The paths of a few bodies as CSV, one row a time: step, time, then for each body in turn its position (x1, y1, z1),
/// its velocity (vx1, ...) and, if asked for, its acceleration (ax1, ...), as many components as there are dimensions;
/// last, where the force has one, the polar angle that belongs to the coordinate.
class TrajectoryCsv {
  public:
    /// @param kept  bytes of a file to go on with; none: a new one  @throws FileError, CheckpointError
    TrajectoryCsv(const OutputPlace& place, Index bodies, int dimensions, bool accelerations, bool angle,
                  std::optional<std::int64_t> kept = std::nullopt);

    /// @pre forces current where accelerations are written; an angle where the file has that column
    /// @throws FileError
    void write(const State& state, std::optional<double> angle);

    void flush() { file_.flush(); }
    void close() { file_.close(); }

    /// What was written so far survives a power cut. @return bytes of it
    std::int64_t commit() { return file_.commit(); }

  private:
    OutputFile file_;
    int dimensions_;
    bool accelerations_;
    bool angle_;
};

}  // namespace ljmd
