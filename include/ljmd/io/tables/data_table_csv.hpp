#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/observables/analysis.hpp"

namespace ljmd {

/// A table as CSV: a header row, then one row a line, numbers with as many digits as it takes to read them back. NaN
/// (an unknown error) is written as an empty field.
[[nodiscard]] std::string to_csv(const DataTable& table);

/// The table that such a file holds; an empty field is NaN. Its name is that of the file, without suffix.
/// @throws DataError  it cannot be read, a row has another number of fields than the header, or a field is no number
[[nodiscard]] DataTable read_csv(const std::filesystem::path& path);

/// The same of a file that may still be written: what follows the last end of a line is left out.
/// @throws DataError
[[nodiscard]] DataTable read_growing_csv(const std::filesystem::path& path);

/// The values of a column, row by row. @throws DataError  there is no such column
[[nodiscard]] std::vector<double> column(const DataTable& table, const std::string& name);

/// The same where each row must have a value.
/// @param path  that the table was read from, for messages
/// @throws DataError  there is no such column, or an empty field in it: names the line
[[nodiscard]] std::vector<double> full_column(const DataTable& table, const std::string& name,
                                              const std::filesystem::path& path);

/// The column `step` of a history: whole numbers, 0 or more, each larger than the one before.
/// @throws DataError  as full_column, or they are not: names the line
[[nodiscard]] std::vector<Index> step_column(const DataTable& table, const std::filesystem::path& path);

}  // namespace ljmd
