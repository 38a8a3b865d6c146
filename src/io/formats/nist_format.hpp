#pragma once

#include "io/files/text_file.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Read a sample configuration of the NIST Standard Reference Simulation Website, in reduced units:
///
///     Lx Ly Lz
///     N
///     id x y z        N times
///
/// The box is centred on the origin, so coordinates outside [0, L) are normal; they are not wrapped.
///
/// @param file  at its start
/// @throws DataError with file and line
/// Source: NIST SRSW, "Lennard-Jones fluid reference calculations: cuboid cell", doi:10.18434/T4M88Q
[[nodiscard]] Configuration read_nist(TextFile& file);

}  // namespace ljmd
