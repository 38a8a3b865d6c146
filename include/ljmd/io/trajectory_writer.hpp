#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "ljmd/core/units.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// What a trajectory file is to hold, and who made it.
struct TrajectoryOptions {
    std::filesystem::path path = {};
    bool velocities = false;                ///< write them beside the positions
    std::optional<SubstanceUnits> si = {};  ///< set: an SI file; else reduced units (unbounded: those of the deck)
    std::string creator_version = {};       ///< version of the program
    std::string author = {};                ///< empty: "unknown"
    std::string title = {};                 ///< of the run; may be empty
};

/// Writes frames to a trajectory file. Atoms stand in the order of their ids, with unwrapped positions. Writing changes
/// nothing in the state.
class TrajectoryWriter {
  public:
    virtual ~TrajectoryWriter() = default;

    /// Append one frame. On return it is on the disk; a kill or a power cut after that does not lose it. When writing
    /// fails, earlier frames stay and every later call throws.
    /// @pre   the number of atoms, and whether there is a box, as when the file was created, else ContractViolation
    /// @throws FileError
    virtual void write(const State& state) = 0;

    /// Flush, fsync and close. A second call does nothing; a writer destroyed without it reports no error.
    /// @throws FileError
    virtual void close() = 0;

  protected:
    TrajectoryWriter() = default;
    TrajectoryWriter(const TrajectoryWriter&) = default;
    TrajectoryWriter& operator=(const TrajectoryWriter&) = default;
};

/// Create the file, replacing one of that name, without any frame yet.
///
/// @param format  "h5md" (H5MD 1.1, the name should end in .h5md) or "xyz" (extended XYZ)
/// @param first   decides the number of atoms and whether there is a box; it is not written
/// @throws InputError  an unknown format
/// @throws FileError   the file cannot be created
[[nodiscard]] std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::string& format, const State& first,
                                                                       const TrajectoryOptions& options);

}  // namespace ljmd
