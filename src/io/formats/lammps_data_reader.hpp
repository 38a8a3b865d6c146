#pragma once

#include "io/files/text_file.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Read a LAMMPS data file in units lj; a first line that names other units is refused.
///
/// Read are the numbers of atoms and of atom types, the bounds of an orthogonal box (tilt factors must be zero, three
/// vectors along the axes) and the sections Masses, Atoms (style atomic: id type x y z, with or without three image
/// flags) and Velocities. All atoms must have one type: ljmd has one kind of atom. Positions are shifted by -(xlo, ylo,
/// zlo) and unwrapped with the image flags.
///
/// A file of another fluid is refused: with Pair Coeffs or PairIJ Coeffs of the type that has atoms other than epsilon
/// = sigma = 1 of a style lj/..., with bonds, angles, dihedrals, impropers, or with bodies other than points. A cutoff
/// in Pair Coeffs gives a remark. Other header lines, other Coeffs and Type Labels are skipped.
///
/// @param file  at its start
/// @throws DataError with file and line
/// Source: LAMMPS documentation, read_data command
[[nodiscard]] Configuration read_lammps_data(TextFile& file);

/// True for a header line "864 atoms", which only this format has.
[[nodiscard]] bool is_lammps_atom_count(std::string_view line);

/// True for a header line "0 10.5 xlo xhi".
[[nodiscard]] bool is_lammps_box_bound(std::string_view line);

}  // namespace ljmd
