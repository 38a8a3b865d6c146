#pragma once

#include <string>

#include "ljmd/observables/analysis.hpp"

namespace ljmd {

/// A table as CSV: a header row, then one row a line, numbers with as many digits as it takes to read them back. NaN
/// (an unknown error) is written as an empty field.
[[nodiscard]] std::string to_csv(const DataTable& table);

}  // namespace ljmd
