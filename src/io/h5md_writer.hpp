#pragma once

#include <optional>

#include "hdf5_output.hpp"
#include "ljmd/io/open_directory.hpp"
#include "ljmd/io/trajectory_writer.hpp"
#include "unit_scale.hpp"

namespace ljmd {

/// A trajectory in H5MD 1.1 (P. de Buyl et al. (2014), doi:10.1016/j.cpc.2014.01.018), in the subset that MDAnalysis,
/// VMD and h5py all read alike:
///
///     h5md                              version [1, 1], author, creator
///     parameters/units                  attributes length, time, velocity: names of the units
///     parameters/vmd_structure          species for VMD: indexOfSpecies, name, type, atomicnumber, mass, radius
///     particles/trajectory/species, id  (N) fixed; ids count from 1
///     particles/trajectory/mass         (N) fixed; reduced files only
///     particles/trajectory/box          dimension, boundary; edges/value (F, 3, 3), a matrix: vectors are misread
///     particles/trajectory/position     step (F), time (F), value (F, N, 3), unwrapped
///     particles/trajectory/velocity     when asked for
///
/// step and time of box and velocity are hard links to those of position. SI files have `unit` attributes nm, ps and
/// nm ps-1; reduced ones have none, because readers refuse units that they do not know.
///
/// A file is gone on with by copying the frames that stay into a new one, which then takes its place: HDF5 does not
/// write to a file that was not closed. Frames are read from their places (FramePlace), not through HDF5.
class H5mdWriter : public TrajectoryWriter {
  public:
    H5mdWriter(const State& first, const TrajectoryOptions& options);
    void write(const State& state) override;
    CommittedFrames commit() override;
    void close() override;

  private:
    /// Numbers of atoms in the order of their ids, (N, 3) by rows, in the units of the file.
    struct Vectors {
        std::vector<double> velocities;  ///< empty when they are not written
        std::vector<double> positions;
    };

    /// Frames of a file that is to be replaced by this one.
    void copy_frames(const OutputPlace& from, const std::vector<FramePlace>& frames);
    void append(const FramePlace& frame, const Vectors& vectors);

    void create_metadata(const TrajectoryOptions& options);
    void create_parameters(const TrajectoryOptions& options);
    void create_box(bool si);
    void create_particles(const State& first, bool si);

    Index count_;
    bool has_box_;
    bool has_velocities_;
    bool failed_ = false;
    std::vector<FramePlace> frames_;
    UnitScale scale_;
    Hdf5Output file_;
    Hdf5Output::Series step_;
    Hdf5Output::Series time_;
    Hdf5Output::Series edges_;
    Hdf5Output::Series velocity_;
    Hdf5Output::Series position_;
};

}  // namespace ljmd
