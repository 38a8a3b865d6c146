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

/// Identifies the last frame of an H5MD file.
struct FrameMark {
    std::int64_t step = 0;
    std::uint64_t place = 0;     ///< offset of its positions in the file
    std::uint64_t checksum = 0;  ///< XXH3 of the positions in its first chunk

    void archive(Archive& a) { a(step, place, checksum); }
};

/// The part of a trajectory file that is known to be on the disk.
struct CommittedFrames {
    std::int64_t bytes = 0;    ///< length of the file
    std::int64_t frames = 0;   ///< number of frames; this and what follows only for H5MD
    std::uint64_t layout = 0;  ///< hash of what determines where frames are
    FrameMark last = {};       ///< the last frame; meaningless without frames

    void archive(Archive& a) { a(bytes, frames, layout, last); }
};

/// Contents of a trajectory file, and its author.
struct TrajectoryOptions {
    OutputPlace path;                          ///< the file; may be given as a path
    bool velocities = false;                   ///< write velocities as well
    std::optional<SubstanceUnits> si = {};     ///< set: SI units; else reduced units (without a box: those of the deck)
    std::string creator_version = {};          ///< version of this program
    std::string author = {};                   ///< empty: "unknown"
    std::string title = {};                    ///< of the run; may be empty
    std::optional<CommittedFrames> kept = {};  ///< from commit(), to continue an existing file; none: a new file
};

/// Writes frames to a trajectory file. Atoms are in the order of ids, with unwrapped positions. The state is not
/// changed.
class TrajectoryWriter {
  public:
    virtual ~TrajectoryWriter() = default;

    /// Append one frame. On return the system has it: readers of the file see it, and a kill does not lose it. A power
    /// cut may, until the next commit(). When writing fails, earlier frames stay and every later call throws.
    /// @pre   the number of atoms and the presence of a box are those of the first state, else ContractViolation
    /// @throws FileError
    virtual void write(const State& state) = 0;

    /// Synchronise all frames so far.
    /// @return the committed part of the file, for TrajectoryOptions::kept
    /// @throws FileError
    virtual CommittedFrames commit() = 0;

    /// Synchronise and close. Does nothing when closed. A writer destroyed without close() reports no error.
    /// @throws FileError
    virtual void close() = 0;

  protected:
    TrajectoryWriter() = default;
    TrajectoryWriter(const TrajectoryWriter&) = default;
    TrajectoryWriter& operator=(const TrajectoryWriter&) = default;
};

/// Create a file without frames, replacing one of that name; or continue an existing one, whether it was closed or not.
///
/// @param format  "h5md" (H5MD 1.1, the name should end in .h5md) or "xyz" (extended XYZ)
/// @param first   decides the number of atoms and whether there is a box; it is not written
/// @throws InputError  unknown format
/// @throws FileError   the file cannot be created
/// @throws CheckpointError  the file to continue is missing, or its frames are not those that were committed
[[nodiscard]] std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::string& format, const State& first,
                                                                       const TrajectoryOptions& options);

/// Approximate size in bytes of a file with this many frames of a fluid. H5MD files grow by chunks, see H5mdWriter.
/// @pre a format of make_trajectory_writer()
[[nodiscard]] double trajectory_bytes(const std::string& format, Index atoms, Index frames, bool velocities);

}  // namespace ljmd
