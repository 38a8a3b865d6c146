#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "ljmd/detail/options/units.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Read a configuration in any format of all_readable_formats(). The format is recognised by content, not by name. Of a
/// trajectory the last frame is read, of an extended XYZ file the only one.
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
