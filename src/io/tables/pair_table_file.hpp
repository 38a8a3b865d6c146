#pragma once

#include <filesystem>
#include <string>

#include "io/files/open_directory.hpp"
#include "potentials/tabulated_pair.hpp"

namespace ljmd {

// A pair potential as a file: JSON with all its values, from which it is made again with the same bits.
// docs/own-parts.md describes the format.

/// "xxh3:" and XXH3 (64 bits) of all values of a table.
[[nodiscard]] std::string checksum_of(const TabulatedPair& pair);

/// Write a table, so that a reader finds all of it or nothing. @throws FileError
void write_pair_table(const OutputPlace& place, const TabulatedPair& pair);

/// The values are as they were written. Whether they make a potential shows TabulatedPair::potential().
/// @param checksum  that the table must have
/// @throws DataError  there is no file, it is no such table or one of another version, it is damaged, or it is another
/// table
[[nodiscard]] TabulatedPair read_pair_table(const std::filesystem::path& path, const std::string& checksum);

}  // namespace ljmd
