#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// The formats for exports: "lammps", "openmm", "extxyz", "h5md".
[[nodiscard]] std::vector<std::string> export_targets();

/// The stage whose time step is exported: the first sampled one, else the last.
[[nodiscard]] const Stage& exported_stage(const Deck& deck);

/// Refuse a directory that an export cannot be written to. Changes nothing.
/// @param force  accept files of an earlier export in it
/// @throws InputError  unknown target, one of its files exists and force is not set, or the path is not a directory
void check_export(const std::string& target, const std::filesystem::path& directory, bool force);

/// The files of an export to a directory. @throws InputError  unknown target
[[nodiscard]] std::vector<std::filesystem::path> export_files(const std::string& target,
                                                              const std::filesystem::path& directory);

/// Result of an export.
struct Exported {
    std::vector<std::filesystem::path> files;
    std::string usage;                  ///< how to use the files, one line or more
    std::vector<std::string> warnings;  ///< differences between ljmd and the other program
};

/// Export a configuration of a fluid, with potential and time step if the format has them. Each file takes
/// its place when it is complete. All numbers are in reduced units.
///
///     lammps   start.data, in.lammps                      its own input: energies of the start, then velocity Verlet
///     openmm   system.xml, state.xml, integrator.xml      sigma = 1 nm, epsilon = 1 kJ/mol, m = 1 u, tau = 1 ps
///     extxyz   start.xyz                                  with velocities
///     h5md     start.h5md                                 one frame, with velocities
///
/// @param forces  with the forces of the deck's potential, in extxyz and h5md
/// @param force   whether existing files of these names are replaced
/// @throws InputError  the other program does not have this potential, or an external force acted on the atoms; forces
/// are asked for where the format has none, or their potential or force was given by a program; OutputRefused as
/// require_writable()
/// @throws FileError
Exported export_configuration(const Deck& deck, const State& state, const std::string& target,
                              const std::filesystem::path& directory, bool forces = false, bool force = false);

}  // namespace ljmd
