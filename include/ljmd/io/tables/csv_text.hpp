#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

// Fields of CSV that hold any text (RFC 4180): one with a comma, a quote or an end of a line stands in quotes, and a
// quote in it is doubled.

/// The fields of a line, without their quotes; blanks around a field without quotes are left out. Nothing when a quote
/// is left open, or something follows a closed one.
[[nodiscard]] std::optional<std::vector<std::string>> csv_fields(std::string_view line);

/// A text, without blanks around it, as a field.
[[nodiscard]] std::string csv_field(const std::string& text);

}  // namespace ljmd
