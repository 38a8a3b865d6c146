#pragma once

#include <string>
#include <string_view>

#include "ljmd/detail/options/value.hpp"

namespace ljmd {

/// A text as a string of TOML: in double quotes, with the escapes that are needed.
[[nodiscard]] std::string toml_string(std::string_view text);

/// A value in one line of TOML. Numbers have as many digits as tell them from others.
[[nodiscard]] std::string toml_value(const Value& value);

/// A table as a text of TOML: plain values first, then its tables with their headers, and what these hold in one line
/// each. Empty tables are left out.
[[nodiscard]] std::string toml_document(const Table& table);

}  // namespace ljmd
