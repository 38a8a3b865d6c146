#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/text_file.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// The column (from 0) in which each property of an atom starts.
struct ExtendedXyzColumns {
    std::size_t position = 0;
    std::optional<std::size_t> velocity;
    std::optional<std::size_t> momentum;  ///< of ASE: mass times velocity, in sqrt(u eV)
    std::optional<std::size_t> force;
    std::optional<std::size_t> id;
    std::optional<std::size_t> mass;
    std::map<std::string, std::size_t> kinds;    ///< properties that distinguish kinds of atoms, see one_kind.hpp
    std::map<std::string, std::size_t> charges;  ///< see OneKind::is_charge()
    std::vector<std::string> unused;             ///< properties of three numbers that nobody takes
    std::size_t count = 0;                       ///< number of columns
};

/// The contents of the comment line of an extended XYZ frame, in the units of the file.
struct ExtendedXyzHeader {
    Vec3 edges = Vec3::Zero();
    ExtendedXyzColumns columns;
    std::optional<double> time;
    std::optional<Index> step;
    std::optional<bool> si;        ///< units=si: angstrom, angstrom/ps, ps, u; units=reduced: false; none: not given
    bool tells_unwrapped = false;  ///< positions=unwrapped: positions continue across the box walls
};

/// Parse a comment line of key=value pairs, without blanks around =. Unknown keys and other words are skipped. Values
/// are bare, in double or single quotes, in braces or in brackets:
///
///     Lattice="10 0 0 0 10 0 0 0 10" Properties=species:S:1:pos:R:3:velo:R:3:id:I:1 pbc="T T T" Time=0 step=0 units=si
///     Lattice=[[10, 0, 0], [0, 10, 0], [0, 0, 10]] pbc={1 1 1}
///
/// Keys and names of properties are case-insensitive. Lattice is required: orthorhombic with a positive diagonal.
/// Properties defaults to species and position.
/// @param file     at the comment line, for messages
/// @param comment  keys missing from the file, in the same form: a box, or units. No key may be in both
/// @throws DataError for a value that cannot be used, or a key with two values
[[nodiscard]] ExtendedXyzHeader parse_extended_xyz_header(const TextFile& file, std::string_view comment = {});

}  // namespace ljmd
