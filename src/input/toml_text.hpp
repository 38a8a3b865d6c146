#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ljmd/detail/options/diagnostics.hpp"
#include "ljmd/detail/options/value.hpp"

namespace ljmd {

/// Parse a TOML 1.0 text. Every key and value has its location in `source`; tables are located at their header.
///
/// The first mistake is reported as one error, and nothing is returned. The message for a syntax error begins with "not
/// valid TOML: ". These have messages of their own: a NUL byte, invalid UTF-8, a number that does not fit in 64 bits, a
/// duplicate key, and brackets or dotted keys deeper than 32 levels. That limit bounds every recursion over the result.
[[nodiscard]] std::optional<Table> parse_toml(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics);

}  // namespace ljmd
