#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

/// Bytes of the UTF-8 character that `text` begins with: 1 to 4; 0 when it begins with none (invalid, cut off,
/// overlong, a surrogate, empty).
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Where `text` stops being UTF-8: the index of the first byte that begins no character, or npos.
[[nodiscard]] std::size_t find_invalid_utf8(std::string_view text);

/// The characters of `text` as a terminal may show them: a tab as a space, other control characters and bytes that are
/// no UTF-8 as '?'.
[[nodiscard]] std::vector<std::string> printable_characters(std::string_view text);

/// The same, joined; after `limit` characters it is cut and ends in "...".
[[nodiscard]] std::string printable(std::string_view text, std::size_t limit);

/// A name or value as messages show it: printable, in single quotes, at most 60 characters.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "-6.0871 +- 0.0012": the error to two digits, the mean to the same decimals; the mean alone to six digits where the
/// error is 0 or not known.
[[nodiscard]] std::string with_error(double mean, double error);

/// A text without the spaces and tabs around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// All of a text as a number, "0.85" or "1e-3", with no blank or plus sign before it; nothing when it is none, not
/// finite or out of range.
[[nodiscard]] std::optional<double> to_number(std::string_view text);

/// Line number `line` (from 1) of `text` without its line end ("\n" or "\r\n"); empty when there is no such line.
[[nodiscard]] std::string_view line_of(std::string_view text, int line);

}  // namespace ljmd
