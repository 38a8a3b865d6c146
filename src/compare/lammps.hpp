#pragma once

#include <memory>

#include "compare/fluid.hpp"
#include "compare/peer.hpp"

namespace ljmd {

/// The fluid in LAMMPS: the program `lmp`, or the one named by the environment variable LJMD_LAMMPS. Each call starts
/// it in a new scratch directory. Its method is "fix nve", velocity Verlet.
///
/// @param threads  of pair styles of the package OPENMP; without the package LAMMPS runs one thread
/// @throws InputError  there is no such program, it is not LAMMPS, or LAMMPS does not have the potential
/// If LAMMPS fails or writes unexpected output, the call throws a DataError with LAMMPS' message.
[[nodiscard]] std::unique_ptr<Peer> make_lammps_peer(const Fluid& fluid, int threads);

}  // namespace ljmd
