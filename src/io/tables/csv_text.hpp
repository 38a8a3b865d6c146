#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

// CSV fields with arbitrary text (RFC 4180): a field with a comma, a quote or a line end is in quotes, and a quote
// within it is doubled.

/// The fields of a line, without their quotes. Blanks around an unquoted field are dropped. Nothing when a quote is not
/// closed or something follows a closing quote.
[[nodiscard]] std::optional<std::vector<std::string>> csv_fields(std::string_view line);

/// A text as a CSV field. @pre no blanks around it: csv_fields() would drop them
[[nodiscard]] std::string csv_field(const std::string& text);

}  // namespace ljmd
