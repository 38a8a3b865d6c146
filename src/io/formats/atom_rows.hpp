#pragma once

#include <string_view>
#include <vector>

#include "io/files/text_file.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// Common to the readers of all formats that have one line per atom.

/// The number of atoms, read from a field of the current line.
/// @param wanted  the required number; 0: any
/// @throws DataError unless it is an integer >= 1, equal to `wanted`, and the file is long enough for it
[[nodiscard]] Index read_atom_count(TextFile& file, std::string_view field, Index wanted = 0);

/// For how many of `count` atoms to reserve memory: at most as many as the rest of the file can hold.
[[nodiscard]] std::size_t expected_atoms(const TextFile& file, Index count);

/// Read the line of the next atom, number `row` (from 0) of `count`.
/// @throws DataError when the file ends or the line is blank
void next_atom_line(TextFile& file, Index row, Index count);

/// The three numbers in `fields`, starting at `first`.
[[nodiscard]] Vec3 read_vector(const TextFile& file, const std::vector<std::string_view>& fields, std::size_t first);

/// The same for numbers that only some commands need: NaN in place of what is no number.
[[nodiscard]] Vec3 read_optional_vector(const std::vector<std::string_view>& fields, std::size_t first);

/// The order of atoms in a block of lines: atom k (from 0) is in line first_line + rows[k].
struct AtomOrder {
    std::vector<Index> ids;  ///< id of atom k in the file; empty when the file has none: ids then count from 1
    std::vector<Index> rows;
    Index first_line = 0;

    [[nodiscard]] Index id(Index k) const { return ids.empty() ? k + 1 : ids[static_cast<std::size_t>(k)]; }
    [[nodiscard]] Index line(Index k) const { return first_line + rows[static_cast<std::size_t>(k)]; }
};

/// The order of the lines, for files without ids.
[[nodiscard]] AtomOrder file_order(Index count, Index first_line);

/// Sort atoms by id. Ids may have gaps, as in a dump of a group or after atoms were deleted.
/// @param ids  in the order of the lines, which begin at first_line
/// @throws DataError with the line of a negative or repeated id
[[nodiscard]] AtomOrder order_by_id(const TextFile& file, const std::vector<Index>& ids, Index first_line);

/// Values in row order, rearranged into atom order: atom k gets the value of rows[k].
template <class T>
[[nodiscard]] std::vector<T> arranged(const std::vector<T>& values, const std::vector<Index>& rows) {
    std::vector<T> sorted;
    if (values.empty()) return sorted;
    sorted.reserve(rows.size());
    for (const Index row : rows) sorted.push_back(values[static_cast<std::size_t>(row)]);
    return sorted;
}

/// Check a configuration in reduced units with find_fault(), O(N).
/// @param header_line  line of the box, for messages
/// @throws DataError that names the atom by its id
void check_frame(const TextFile& file, const Configuration& configuration, const AtomOrder& order, Index header_line);

/// As check_frame(), for a start configuration, O(N log N): also no two atoms may be at the same place modulo the box.
void check_configuration(const TextFile& file, const Configuration& configuration, const AtomOrder& order,
                         Index header_line);

}  // namespace ljmd
