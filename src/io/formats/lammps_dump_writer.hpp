#pragma once

#include "io/files/output_file.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Append one frame as LAMMPS writes it in a text dump, in reduced units (LAMMPS: lj), atoms in the order of ids:
///
///     ITEM: TIMESTEP                                      state.step
///     ITEM: NUMBER OF ATOMS
///     ITEM: BOX BOUNDS pp pp pp                           from 0
///     ITEM: ATOMS id type x y z ix iy iz vx vy vz fx fy fz c_pe
///
/// Positions are in the box, with the number of edges crossed; of a copy whose source does not tell that its positions
/// are unwrapped, they are as there, without ix iy iz. Velocities, forces and energies (c_pe, as of LAMMPS'
/// compute pe/atom) stand there where they are asked for. The time is left out: readers such as MDAnalysis refuse
/// ITEM: TIME. Numbers have as many digits as are needed to read back the same double.
/// @pre the state has a box, and its atoms are in it; the source of a copy has a step (ContractViolation)
/// Source: LAMMPS documentation, dump command
/// @throws FileError
void write_lammps_dump_frame(OutputFile& file, const State& state, const FrameContents& contents);

}  // namespace ljmd
