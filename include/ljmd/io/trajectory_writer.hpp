#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/units.hpp"
#include "ljmd/io/open_directory.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// A frame of an H5MD file by the places of its numbers, so that it can be read whatever became of the rest: what HDF5
/// keeps around frames is written over again and again, and unreadable when the last time was cut off.
struct FramePlace {
    std::int64_t step = 0;
    double time = 0.0;                      ///< in the units of the file, like the edges
    std::array<double, 9> edges{};          ///< by rows; zero without a box
    std::vector<std::uint64_t> velocities;  ///< of the chunks, first atoms first; none when they are not written
    std::vector<std::uint64_t> positions;
    std::uint64_t checksum = 0;  ///< XXH3 of velocities and positions

    void archive(Archive& a) { a(step, time, edges, velocities, positions, checksum); }
};

/// The part of a trajectory file that is on the disk for good.
struct CommittedFrames {
    std::int64_t bytes = 0;          ///< of a text file
    std::vector<FramePlace> frames;  ///< of an H5MD file

    void archive(Archive& a) { a(bytes, frames); }
};

/// What a trajectory file is to hold, and who made it.
struct TrajectoryOptions {
    OutputPlace path;                          ///< of the file; may be given as a path
    bool velocities = false;                   ///< write them beside the positions
    std::optional<SubstanceUnits> si = {};     ///< set: an SI file; else reduced units (unbounded: those of the deck)
    std::string creator_version = {};          ///< version of the program
    std::string author = {};                   ///< empty: "unknown"
    std::string title = {};                    ///< of the run; may be empty
    std::optional<CommittedFrames> kept = {};  ///< of a file to go on with, as commit() told it; none: a new one
};

/// Writes frames to a trajectory file. Atoms stand in the order of their ids, with unwrapped positions. Writing changes
/// nothing in the state.
class TrajectoryWriter {
  public:
    virtual ~TrajectoryWriter() = default;

    /// Append one frame. On return the system has it: readers of the file see it, and a kill does not lose it. A power
    /// cut may, until the next commit(). When writing fails, earlier frames stay and every later call throws.
    /// @pre   the number of atoms, and whether there is a box, as when the file was created, else ContractViolation
    /// @throws FileError
    virtual void write(const State& state) = 0;

    /// All frames so far are on the disk.
    /// @return which part of the file they are, from which it can be gone on with (TrajectoryOptions::kept)
    /// @throws FileError
    virtual CommittedFrames commit() = 0;

    /// Flush, fsync and close. A second call does nothing; a writer destroyed without it reports no error.
    /// @throws FileError
    virtual void close() = 0;

  protected:
    TrajectoryWriter() = default;
    TrajectoryWriter(const TrajectoryWriter&) = default;
    TrajectoryWriter& operator=(const TrajectoryWriter&) = default;
};

/// Create the file, replacing one of that name, without any frame yet; or go on with the frames of one that exists,
/// whether it was closed or not.
///
/// @param format  "h5md" (H5MD 1.1, the name should end in .h5md) or "xyz" (extended XYZ)
/// @param first   decides the number of atoms and whether there is a box; it is not written
/// @throws InputError  an unknown format
/// @throws FileError   the file cannot be created
/// @throws CheckpointError  the file to go on with is not there, or has not the frames that it had
[[nodiscard]] std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::string& format, const State& first,
                                                                       const TrajectoryOptions& options);

}  // namespace ljmd
