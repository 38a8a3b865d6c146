#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/units.hpp"
#include "ljmd/io/files/open_directory.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// By what the last frame of an H5MD file is known again.
struct FrameMark {
    std::int64_t step = 0;
    std::uint64_t place = 0;     ///< of its positions in the file
    std::uint64_t checksum = 0;  ///< XXH3 of the positions in its first chunk

    void archive(Archive& a) { a(step, place, checksum); }
};

/// The part of a trajectory file that is on the disk for good.
struct CommittedFrames {
    std::int64_t bytes = 0;    ///< of the file
    std::int64_t frames = 0;   ///< of an H5MD file, like all that follows
    std::uint64_t layout = 0;  ///< what decides where its frames lie
    FrameMark last = {};       ///< of the last frame; of no meaning without frames

    void archive(Archive& a) { a(bytes, frames, layout, last); }
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

/// Bytes of a file of so many frames of a fluid, about. An H5MD file grows by chunks, see H5mdWriter.
/// @pre a format of make_trajectory_writer()
[[nodiscard]] double trajectory_bytes(const std::string& format, Index atoms, Index frames, bool velocities);

}  // namespace ljmd
