#pragma once

#include <memory>
#include <optional>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/value.hpp"

namespace ljmd {

/// Read a TOML 1.0 text. Every key and value is located in `source`; tables are located at their header.
///
/// At the first mistake one error is reported and nothing returned. A mistake of the grammar has a message that begins
/// with "not valid TOML: "; a NUL byte, invalid UTF-8, a number that 64 bits do not hold, a key given twice, and
/// brackets or dotted keys deeper than 32 levels (which guards every recursion over the result) have one of their own.
[[nodiscard]] std::optional<Table> parse_toml(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

}  // namespace ljmd
