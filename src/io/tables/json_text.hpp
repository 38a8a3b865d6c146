#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "ljmd/detail/core/data.hpp"

namespace ljmd {

// The one place where JSON is written and read. Values are written with nlohmann's library: numbers with as many digits
// as it takes to read the same double back; -0 as 0.

// Limits, so that reading, copying and printing need little stack, memory and time. Larger values count as mistakes.
inline constexpr int deepest_json = 32;                    ///< depth of nested arrays and objects
inline constexpr std::size_t max_json_values = 1'000'000;  ///< in all arrays and objects
inline constexpr std::size_t max_json_keys = 1000;         ///< in an object; lookups are linear in it

/// JSON, indented by two spaces, without a line end at its end. Bytes that are not UTF-8, as in names of files or in
/// strings from a checkpoint, become U+FFFD.
[[nodiscard]] std::string to_json(const Data& data);

/// JSON on one line, in ASCII, for messages.
[[nodiscard]] std::string to_json_line(const Data& data);

/// Parse a JSON text. Objects keep their order; of members with the same key the last one counts.
/// @throws WrongData  it is not JSON, is nested deeper than `deepest_json`, has more than `max_json_values` values, or
/// has an object with more than `max_json_keys` keys
[[nodiscard]] Data parse_json(std::string_view text);

}  // namespace ljmd
