#pragma once

#include <memory>

#include "ljmd/compare/fluid.hpp"
#include "ljmd/compare/peer.hpp"

namespace ljmd {

/// The fluid in LAMMPS: the program `lmp`, or the one that the environment's LJMD_LAMMPS names. Each call starts it
/// anew in a scratch directory. Its method is "fix nve", velocity Verlet.
///
/// @param threads  of pair styles of the package OPENMP; a LAMMPS without it has one
/// @throws InputError  there is no such program, it is no LAMMPS, or LAMMPS has no such potential
/// What LAMMPS refuses, or says otherwise than expected, is a DataError of the call, with LAMMPS' own words.
[[nodiscard]] std::unique_ptr<Peer> make_lammps_peer(const Fluid& fluid, int threads);

}  // namespace ljmd
