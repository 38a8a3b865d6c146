#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

/// The first line of a table. @pre no name needs quotes
[[nodiscard]] std::string csv_header(const std::vector<std::string>& columns);

/// A line of a table: numbers with as many digits as are needed to read them back. What is not finite (an unknown
/// error, an undefined quantity) becomes an empty field.
[[nodiscard]] std::string csv_row(const std::vector<double>& row);

/// A table as CSV: csv_header(), then csv_row() for each row.
[[nodiscard]] std::string to_csv(const DataTable& table);

/// Read a table; an empty field is NaN. The table is named after the file, without suffix. As other programs write it,
/// the header may begin with '#', and have names in quotes; there may be blanks beside commas.
/// @throws DataError  the file cannot be read, a row and the header differ in length, or a field is not a number
[[nodiscard]] DataTable read_csv(const std::filesystem::path& path);

/// The names in the header alone; none of an empty file. @throws DataError
[[nodiscard]] std::vector<std::string> csv_columns(const std::filesystem::path& path);

/// As read_csv(), up to the first row with a number that is not finite, if that is not the first one.
/// @param loss  receives which number it is, with file and line; unchanged if there is none
/// @throws DataError
[[nodiscard]] DataTable read_finite_csv(const std::filesystem::path& path, std::string& loss);

/// As read_csv(), for a file that is still being written: anything after the last line end is ignored.
/// @throws DataError
[[nodiscard]] DataTable read_growing_csv(const std::filesystem::path& path);

/// The values of a column. @throws DataError  there is no such column
[[nodiscard]] std::vector<double> column(const DataTable& table, const std::string& name);

/// As column(), but every row must have a value.
/// @param path  of the table, for messages
/// @throws DataError  there is no such column, or a field is empty: names the line
[[nodiscard]] std::vector<double> full_column(const DataTable& table, const std::string& name,
                                              const std::filesystem::path& path);

/// The column `step` of a history: integers >= 0, strictly increasing.
/// @throws DataError  as full_column(), or the steps are wrong: names the line
[[nodiscard]] std::vector<Index> step_column(const DataTable& table, const std::filesystem::path& path);

}  // namespace ljmd
