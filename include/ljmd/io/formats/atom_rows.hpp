#pragma once

#include <string_view>
#include <vector>

#include "ljmd/io/files/text_file.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd {

/// What the readers of all formats do alike with a block of lines that holds one atom each.

/// The number of atoms that the current line announces.
/// @param wanted  how many there must be; 0: any number
/// @throws DataError unless it is an integer of at least 1, that number, for which the file has room
[[nodiscard]] Index read_atom_count(TextFile& file, std::string_view field, Index wanted = 0);

/// For how many of `count` atoms to reserve memory: no more than the rest of the file can hold.
[[nodiscard]] std::size_t expected_atoms(const TextFile& file, Index count);

/// Go to the line of the next atom, number `row` (from 0) of `count`.
/// @throws DataError when the file ends or the line is blank
void next_atom_line(TextFile& file, Index row, Index count);

/// Three numbers that stand in `fields` from `first` on.
[[nodiscard]] Vec3 read_vector(const TextFile& file, const std::vector<std::string_view>& fields, std::size_t first);

/// Where the atoms stand in a block of lines: atom k (from 0) in the line first_line + rows[k].
struct AtomOrder {
    std::vector<Index> ids;  ///< of atom k, as the file has them; empty when it has none: then they count from 1
    std::vector<Index> rows;
    Index first_line = 0;

    [[nodiscard]] Index id(Index k) const { return ids.empty() ? k + 1 : ids[static_cast<std::size_t>(k)]; }
    [[nodiscard]] Index line(Index k) const { return first_line + rows[static_cast<std::size_t>(k)]; }
};

/// The order in which the file lists its atoms, for files without ids.
[[nodiscard]] AtomOrder file_order(Index count, Index first_line);

/// Sort by id. Ids may have gaps: a dump of a group of atoms, or a file from which atoms were deleted, has them.
/// @param ids  as written, one a line from first_line on
/// @throws DataError with its line for a negative or repeated id
[[nodiscard]] AtomOrder order_by_id(const TextFile& file, const std::vector<Index>& ids, Index first_line);

/// Values as read, row by row, in the order of the atoms: atom k is that of rows[k].
template <class T>
[[nodiscard]] std::vector<T> arranged(const std::vector<T>& values, const std::vector<Index>& rows) {
    std::vector<T> sorted;
    if (values.empty()) return sorted;
    sorted.reserve(rows.size());
    for (const Index row : rows) sorted.push_back(values[static_cast<std::size_t>(row)]);
    return sorted;
}

/// Refuse what find_fault() finds in a configuration in reduced units, O(N).
/// @param header_line  where the box stands
/// @throws DataError that names the atom by its id
void check_frame(const TextFile& file, const Configuration& configuration, const AtomOrder& order, Index header_line);

/// The same for a configuration that a run can start from, O(N log N): no two atoms are at the same place modulo the
/// box, either.
void check_configuration(const TextFile& file, const Configuration& configuration, const AtomOrder& order,
                         Index header_line);

}  // namespace ljmd
