#pragma once

#include "../hdf5/hdf5_output.hpp"
#include "ljmd/io/formats/trajectory_writer.hpp"
#include "unit_scale.hpp"

namespace ljmd {

/// A trajectory in H5MD 1.1 (P. de Buyl et al. (2014), doi:10.1016/j.cpc.2014.01.018), in the subset that MDAnalysis,
/// VMD and h5py all read:
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
/// step and time of box and velocity are hard links to those of position. Files in SI units have `unit` attributes nm,
/// ps and nm ps-1; reduced files have none, because readers refuse unknown units.
///
/// A chunk holds up to 64 frames and up to 64 KiB; larger frames have chunks of their own, those above 1 MiB several.
/// So HDF5's records of chunks are small, and their number grows with the number of chunks, not of frames.
///
/// An interrupted file is continued in place: HDF5's records are written again (Hdf5Output::continue_appending), frames
/// are not touched.
class H5mdWriter : public TrajectoryWriter {
  public:
    H5mdWriter(const State& first, const TrajectoryOptions& options);
    void write(const State& state) override;
    CommittedFrames commit() override;
    void close() override;

  private:
    void require_kept(const TrajectoryOptions& options);

    void create_metadata(const TrajectoryOptions& options);
    void create_parameters(const TrajectoryOptions& options);
    void create_box(bool si);
    void create_particles(const State& first, bool si);

    Index count_;
    bool has_box_;
    bool has_velocities_;
    bool failed_ = false;
    FrameMark last_;
    UnitScale scale_;
    Hdf5Output file_;
    Hdf5Output::Series step_;
    Hdf5Output::Series time_;
    Hdf5Output::Series edges_;
    Hdf5Output::Series velocity_;
    Hdf5Output::Series position_;
};

/// See trajectory_bytes().
[[nodiscard]] double h5md_bytes(Index atoms, Index frames, bool velocities);

}  // namespace ljmd
