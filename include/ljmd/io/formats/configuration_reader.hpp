#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ljmd/core/units.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Read a configuration from any supported format; the format is recognised by content, not by name:
///
/// - NIST sample configuration: the first line is three numbers, see nist_format.hpp;
/// - extended XYZ: the first line is one number, see extended_xyz_reader.hpp;
/// - LAMMPS data: one of the first lines after the first is "N atoms", see lammps_data_reader.hpp. Its first line is a
///   title; where that is made of numbers, there must be bounds of a box, too;
/// - H5MD: an HDF5 file, see h5md_reader.hpp; the last frame is taken.
///
/// The result keeps the promises of Configuration; positions are not wrapped into the box, and no two atoms are at the
/// same place modulo the box. Memory is bounded by the size of the file, whatever its header claims.
///
/// @param units        of the substance, for files in SI units; empty when the deck has no [argon]
/// @param xyz_comment  what the comment lines of an extended XYZ file lack
/// @throws DataError with file, line and frame when the file is missing, not a regular file, of unknown format or wrong
[[nodiscard]] Configuration read_configuration(const std::filesystem::path& path,
                                               const std::optional<SubstanceUnits>& units,
                                               const std::string& xyz_comment = {});

}  // namespace ljmd
