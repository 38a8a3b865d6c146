#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/files/open_directory.hpp"
#include "io/files/output_file.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/options/units.hpp"

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
    bool forces = false;                       ///< write forces as well
    bool energies = false;                     ///< write the energies of the atoms as well
    std::optional<SubstanceUnits> si = {};     ///< set: SI units; else reduced units (without a box: the deck's)
    std::string creator_version = {};          ///< version of this program
    std::string author = {};                   ///< empty: "unknown"
    std::string title = {};                    ///< of the run; may be empty
    std::optional<CommittedFrames> kept = {};  ///< from commit(), to continue an existing file; none: a new file
};

/// Writes frames to a trajectory file. Atoms are in the order of ids, with unwrapped positions. The state is not
/// changed. Of several ranks that share it, rank 0 has the writer, and uses it in look_by_id().
class TrajectoryWriter {
  public:
    virtual ~TrajectoryWriter() = default;

    /// Append one frame. On return the system has it: readers of the file see it, and a kill does not lose it. A power
    /// cut may, until the next commit(). When writing fails, earlier frames stay and every later call throws.
    /// @param energies  of the atoms, by id, if the file has them, else none: see atom_energies()
    /// @pre   the number of atoms and the presence of a box are as in the first state, there are energies where the
    /// file has them, and forces are current where it has forces, else ContractViolation
    /// @throws FileError
    void write(const State& state, std::span<const double> energies = {});

    /// Synchronise all frames so far.
    /// @return the committed part of the file, for TrajectoryOptions::kept
    /// @throws FileError
    virtual CommittedFrames commit() = 0;

    /// Synchronise and close. Does nothing when closed. A writer destroyed without close() reports no error.
    /// @throws FileError
    virtual void close() = 0;

  protected:
    /// @param first    has as many atoms as every frame, and a box if the frames have one
    /// @param options  what the frames contain
    TrajectoryWriter(const State& first, const TrajectoryOptions& options)
        : count_(first.total()),
          has_box_(first.has_box()),
          has_forces_(options.forces),
          has_energies_(options.energies) {}
    TrajectoryWriter(const TrajectoryWriter&) = default;
    TrajectoryWriter& operator=(const TrajectoryWriter&) = default;

    /// write() of a state that meets its precondition.
    virtual void append(const State& state, std::span<const double> energies) = 0;

  private:
    Index count_;
    bool has_box_;
    bool has_forces_;
    bool has_energies_;
};

/// Creates a file without frames, replacing one of that name; or continues an existing one, closed or not.
/// The first state decides the number of atoms and whether there is a box; it is not written.
using MakeTrajectory =
    std::function<std::unique_ptr<TrajectoryWriter>(const State& first, const TrajectoryOptions& options)>;

/// What the frames of a file hold of each atom beside its position.
struct AtomColumns {
    bool velocities = false;
    bool forces = false;
    bool energies = false;
};

/// A format in which runs write trajectories. Each is one file in src/io/formats/trajectories.
///
/// Every format holds periodic boxes and, for few bodies, none; velocities, forces and energies of the atoms where
/// asked for; reduced and SI units; the step and the time of each frame. Nothing that a later frame depends on is kept
/// but CommittedFrames.
struct TrajectoryFormat {
    std::string name;      ///< as a deck selects it; the file is trajectory.<name>
    std::string meaning;   ///< what the format is called, for the reference page: "extended XYZ"
    std::string si_units;  ///< of length and time in files in SI units: "angstrom, ps"
    bool is_read;          ///< open_trajectory() reads its fluids in reduced units, so `ljmd analyze` can
    MakeTrajectory make;
    /// Approximate size of a file with so many frames of a fluid [bytes].
    std::function<double(Index atoms, Index frames, const AtomColumns& columns)> bytes;
};

/// Every format, in alphabetical order.
[[nodiscard]] std::vector<TrajectoryFormat> all_trajectory_formats();

/// Appends one frame to a text file.
using WriteFrame = std::function<void(OutputFile& file, const State& state, std::span<const double> energies,
                                      const TrajectoryOptions& options)>;

/// TrajectoryFormat::make of a text format, whose file is one frame after the other.
[[nodiscard]] MakeTrajectory text_trajectory(const WriteFrame& write_frame);

/// A trajectory in the format of this name, see MakeTrajectory.
/// @throws InputError  unknown format
/// @throws FileError   the file cannot be created
/// @throws CheckpointError  the file to continue is missing, or its frames are not those that were committed
[[nodiscard]] std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::string& format, const State& first,
                                                                       const TrajectoryOptions& options);

/// TrajectoryFormat::bytes of the format of this name. @throws InputError  unknown format
[[nodiscard]] double trajectory_bytes(const std::string& format, Index atoms, Index frames, const AtomColumns& columns);

}  // namespace ljmd
