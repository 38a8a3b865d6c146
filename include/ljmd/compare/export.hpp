#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/deck/deck.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// What a configuration can be exported to: "lammps", "openmm", "extxyz", "h5md".
[[nodiscard]] std::vector<std::string> export_targets();

/// The stage whose time step an export takes: the first sampled one, or else the last.
[[nodiscard]] const Stage& exported_stage(const Deck& deck);

/// Refuse a directory that an export cannot be written to. Changes nothing.
/// @param force  files of an earlier export in it are no reason to refuse
/// @throws InputError  an unknown target, one of its files is there and force is not given, or it is not a directory
void check_export(const std::string& target, const std::filesystem::path& directory, bool force);

/// What an export to a directory writes. @throws InputError  an unknown target
[[nodiscard]] std::vector<std::filesystem::path> export_files(const std::string& target,
                                                              const std::filesystem::path& directory);

/// What was written.
struct Exported {
    std::vector<std::filesystem::path> files;
    std::string usage;                  ///< how to go on from it, a line or more
    std::vector<std::string> warnings;  ///< what the other program does not do as ljmd does
};

/// Write a fluid's configuration, with potential and time step where the target has a place for them. Each file is
/// either the old or the new one, never half of it. All is in reduced units.
///
///     lammps   start.data, in.lammps                      its own input: energies of the start, then velocity Verlet
///     openmm   system.xml, state.xml, integrator.xml      sigma = 1 nm, epsilon = 1 kJ/mol, m = 1 u, tau = 1 ps
///     extxyz   start.xyz                                  with velocities
///     h5md     start.h5md                                 one frame, with velocities
///
/// @pre check_export accepted it
/// @throws InputError  the other program has no such potential
/// @throws FileError
Exported export_configuration(const Deck& deck, const State& state, const std::string& target,
                              const std::filesystem::path& directory);

}  // namespace ljmd
