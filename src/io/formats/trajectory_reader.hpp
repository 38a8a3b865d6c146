#pragma once

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/formats/configuration_check.hpp"
#include "ljmd/detail/options/units.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// One frame of a trajectory. Positions may lie outside the box. Velocities may be missing in some frames.
struct Frame {
    Configuration configuration;
    std::vector<Index> ids{};  ///< of the atoms, ascending; empty if the file has none
    bool begins_anew = false;  ///< true where this frame does not continue the one before it, because files were joined
    /// On the atoms [epsilon/sigma], as some program has computed them; empty if the file has none. ljmd judges them,
    /// and computes its own for everything else. NaN where the file has no finite number.
    std::vector<Vec3> forces{};
};

/// Reads the frames of a trajectory one after the other. One frame is in memory at a time, besides the positions of the
/// last counted one.
///
/// In a file to which several runs were appended, steps (or times, if there are no steps) repeat or go back. Each is
/// counted once, at its first occurrence; repeated frames are skipped. What follows either continues the last counted
/// frame, if the repeated frames reach it, or begins anew.
class TrajectoryReader {
  public:
    virtual ~TrajectoryReader() = default;

    /// Read the next frame.
    /// @return false after the last complete frame; `frame` is then unspecified
    /// @throws DataError with file, frame (and line of a text file) for damaged content: a value that is not a finite
    /// number, a tilted or non-periodic box, other atoms than in the first frame, a step or time that only some frames
    /// have, more than one kind of atom; also for a file that ends within its first frame
    bool next(Frame& frame);

    /// Complete frames read so far, skipped ones included.
    [[nodiscard]] Index frames() const { return frames_; }

    /// Remarks on the file: it ends within a frame, was not closed, repeats frames, or an assumption was made. Complete
    /// at the end of the file; empty if there are none.
    [[nodiscard]] std::vector<std::string> warnings() const;

    /// Why no frame has velocities although the file has some, "at other steps than the positions"; otherwise empty.
    [[nodiscard]] const std::string& unused_velocities() const { return unused_velocities_; }

  protected:
    TrajectoryReader() = default;
    TrajectoryReader(const TrajectoryReader&) = default;
    TrajectoryReader& operator=(const TrajectoryReader&) = default;

    /// @return false when there is no further frame  @throws DataError
    virtual bool read(Frame& frame) = 0;

    /// Whether the file was cut off at the place read last.
    [[nodiscard]] virtual bool is_cut() const { return false; }

    /// Report a fault of the current frame. @throws DataError always
    [[noreturn]] virtual void fail(const std::string& message) const = 0;

    /// Report the fault of a frame's configuration, of the atom with this id.
    /// @throws NotFinite  the atom is lost  @throws DataError  in all other cases
    [[noreturn]] void fail_by(const ConfigurationFault& fault, Index id) const;

    /// Atoms in the first frame; 0 while that is read.
    [[nodiscard]] Index atoms() const { return atoms_; }

    /// Add a warning; repeated ones are kept once.
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

    std::vector<Vec3> last_positions_;  ///< of the last counted frame; last_place_ is its step or time
    double last_place_ = -std::numeric_limits<double>::infinity();
    Index repeated_ = 0;        ///< number of skipped frames
    Index first_repeated_ = 0;  ///< the first of them, counting from 1
    bool is_joined_ = true;     ///< the next frame continues the last counted one
    bool begins_anew_ = false;  ///< somewhere a frame did not
};

/// Open a trajectory in a format of all_readable_formats() that holds several frames. The format is recognised by
/// content, not by name.
///
/// @param units        of the substance, for files in SI units; empty: these are refused
/// @param group        particle group of an H5MD file; empty: the only one
/// @param xyz_comment  keys missing from the comment lines of an extended XYZ file
/// @throws DataError when the file is missing, not a regular file, of unknown format, without such a group, or when a
/// comment is given for a file that is not extended XYZ
[[nodiscard]] std::unique_ptr<TrajectoryReader> open_trajectory(const std::filesystem::path& path,
                                                                const std::optional<SubstanceUnits>& units,
                                                                const std::string& group = {},
                                                                const std::string& xyz_comment = {});

}  // namespace ljmd
