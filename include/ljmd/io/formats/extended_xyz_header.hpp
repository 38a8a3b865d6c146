#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "ljmd/core/types.hpp"
#include "ljmd/io/files/text_file.hpp"

namespace ljmd {

/// In which column of an atom's line each property starts (from 0).
struct ExtendedXyzColumns {
    std::size_t position = 0;
    std::optional<std::size_t> velocity;
    std::optional<std::size_t> momentum;  ///< of ASE: mass times velocity, in sqrt(u eV)
    std::optional<std::size_t> id;
    std::optional<std::size_t> mass;
    std::map<std::string, std::size_t> kinds;  ///< of properties that tell kinds of atoms apart, see one_kind.hpp
    std::size_t count = 0;                     ///< columns in all
};

/// What the comment line of an extended XYZ frame says, in the units of the file.
struct ExtendedXyzHeader {
    Vec3 edges = Vec3::Zero();
    ExtendedXyzColumns columns;
    std::optional<double> time;
    std::optional<Index> step;
    std::optional<bool> si;        ///< units=si: angstrom, angstrom/ps, ps, u; units=reduced: false; none: not told
    bool tells_unwrapped = false;  ///< positions=unwrapped: those of atoms that leave the box go on
};

/// Parse a comment line: key=value pairs without blanks around =, unknown keys and other words skipped. Values are
/// bare, in double or single quotes, in braces or in brackets, as in
///
///     Lattice="10 0 0 0 10 0 0 0 10" Properties=species:S:1:pos:R:3:velo:R:3:id:I:1 pbc="T T T" Time=0 step=0 units=si
///     Lattice=[[10, 0, 0], [0, 10, 0], [0, 0, 10]] pbc={1 1 1}
///
/// Keys are found in any case. Lattice is required, orthorhombic with positive diagonal. Without Properties: species
/// and position.
/// @param file     at the comment line, for messages
/// @param comment  what the lines of the file lack, in the same form: a box, or units. No key may stand in both
/// @throws DataError for a value that cannot be used, or a key that is given two values
[[nodiscard]] ExtendedXyzHeader parse_extended_xyz_header(const TextFile& file, std::string_view comment = {});

}  // namespace ljmd
