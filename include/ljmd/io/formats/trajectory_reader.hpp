#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/units.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// One frame of a trajectory. Its positions may lie anywhere. Not all frames need have velocities.
struct Frame {
    Configuration configuration;  ///< step and time are 0 where the file has none
    bool has_step = false;
    bool has_time = false;
    /// The file says that the position of an atom goes on where it leaves the box, or image flags that were applied
    /// say where it is.
    bool tells_unwrapped = false;
    std::vector<Index> ids{};  ///< of the atoms, ascending; empty where the file has none
    bool begins_anew = false;  ///< does not go on from the frame before it: files were joined
};

/// Reads the frames of a trajectory one after the other. A frame is in memory at a time, and what is kept of another.
///
/// Where runs were appended to one file, steps (times, where there are no steps) come again or go back. Each is counted
/// once, as it came first; frames that come again are passed over. What follows goes on from where the repeated frames
/// meet the last one that was counted, or begins anew.
class TrajectoryReader {
  public:
    virtual ~TrajectoryReader() = default;

    /// Read the next frame.
    /// @return false behind the last whole one; `frame` is then of no use
    /// @throws DataError with file, frame (and line of a text file) for whatever is damaged: a number that is none or
    /// not finite, a box that is tilted or not periodic, other atoms than in the first frame, a step or time that not
    /// all frames have, more than one kind of atom; also for a file that ends within its first frame
    bool next(Frame& frame);

    /// Whole frames that were read, with those that were passed over.
    [[nodiscard]] Index frames() const { return frames_; }

    /// What is to be told of the file: that it ends within a frame, was not closed, repeats frames, or what was
    /// assumed. Known at its end; empty if all is well.
    [[nodiscard]] std::vector<std::string> warnings() const;

    /// Why no frame has velocities although the file has some, "at other steps than the positions"; else empty.
    [[nodiscard]] const std::string& unused_velocities() const { return unused_velocities_; }

  protected:
    TrajectoryReader() = default;
    TrajectoryReader(const TrajectoryReader&) = default;
    TrajectoryReader& operator=(const TrajectoryReader&) = default;

    /// @return false when there is no other frame  @throws DataError
    virtual bool read(Frame& frame) = 0;

    /// Whether what was read last is where the file was cut off.
    [[nodiscard]] virtual bool is_cut() const { return false; }

    /// That a frame has other contents than the first one. @throws DataError always
    [[noreturn]] virtual void fail(const std::string& message) const = 0;

    /// Atoms in the first frame; 0 while it is read.
    [[nodiscard]] Index atoms() const { return atoms_; }

    /// Add to the warnings; each is told once.
    void warn(const std::string& text);
    void leave_velocities(std::string why) { unused_velocities_ = std::move(why); }

  private:
    bool read_whole(Frame& frame);
    void check_like_first(const Frame& frame);
    bool is_counted(Frame& frame);

    Index frames_ = 0;
    Index atoms_ = 0;
    bool has_step_ = false;
    bool has_time_ = false;
    std::vector<Index> ids_;  ///< of the atoms in the first frame
    std::vector<std::string> warnings_;
    std::string unused_velocities_;

    std::vector<Vec3> last_positions_;  ///< of the last frame that was counted, and its place:
    double last_place_ = -std::numeric_limits<double>::infinity();
    Index repeated_ = 0;        ///< frames that were passed over
    Index first_repeated_ = 0;  ///< the first of them, from 1
    bool is_joined_ = true;     ///< what follows goes on from the last frame that was counted
    bool begins_anew_ = false;  ///< somewhere it does not
};

/// Open a trajectory of any supported format; the format is recognised by content, not by name:
///
/// - H5MD: an HDF5 file, see h5md_reader.hpp;
/// - LAMMPS dump: the first line begins with "ITEM:", see lammps_dump.hpp;
/// - extended XYZ: the first line is one number, see extended_xyz_reader.hpp.
///
/// @param units        of the substance, for files in SI units; empty: they are refused
/// @param group        of particles, in an H5MD file; empty: the only one
/// @param xyz_comment  what the comment lines of an extended XYZ file lack
/// @throws DataError when the file is missing, not a regular file, of unknown format, has no such group, or is no
/// extended
///                   XYZ for a comment
[[nodiscard]] std::unique_ptr<TrajectoryReader> open_trajectory(const std::filesystem::path& path,
                                                                const std::optional<SubstanceUnits>& units,
                                                                const std::string& group = {},
                                                                const std::string& xyz_comment = {});

}  // namespace ljmd
