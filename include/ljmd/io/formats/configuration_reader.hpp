#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ljmd/model/configuration.hpp"
#include "ljmd/options/units.hpp"

namespace ljmd {

/// Read a configuration in any supported format. The format is recognised by content, not by name:
///
/// - NIST sample configuration: the first line is three numbers, see nist_format.hpp;
/// - extended XYZ: the first line is one number, see extended_xyz_reader.hpp;
/// - LAMMPS data: "N atoms" is in one of the lines after the first, see lammps_data_reader.hpp. The first line is a
///   title; if it consists of one or three numbers, the bounds of a box are required, too;
/// - H5MD: an HDF5 file, see h5md_reader.hpp; the last frame is read.
///
/// The result meets the contract of Configuration. Positions are not wrapped into the box; no two atoms are at the same
/// place modulo the box. Memory is bounded by the size of the file, whatever its header says.
///
/// @param units        of the substance, for files in SI units; empty when the deck has no [argon]
/// @param xyz_comment  keys missing from the comment lines of an extended XYZ file
/// @throws DataError with file, line and frame, when the file is missing, not a regular file, unknown or wrong
[[nodiscard]] Configuration read_configuration(const std::filesystem::path& path,
                                               const std::optional<SubstanceUnits>& units,
                                               const std::string& xyz_comment = {});

/// Whether a file has a format that holds one configuration and no trajectory: NIST sample configuration, LAMMPS data.
/// @throws DataError  the file is missing, not a regular file, or empty
[[nodiscard]] bool holds_one_configuration(const std::filesystem::path& path);

}  // namespace ljmd
