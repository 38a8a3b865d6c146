#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

/// Length in bytes of the first UTF-8 character of `text`, 1 to 4; 0 if it is invalid (cut off, overlong, a surrogate)
/// or if `text` is empty.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Index of the first byte of `text` that begins no UTF-8 character, or npos.
[[nodiscard]] std::size_t find_invalid_utf8(std::string_view text);

/// The characters of `text` as a terminal may show them: a tab becomes a space, other control characters and invalid
/// UTF-8 become '?'.
[[nodiscard]] std::vector<std::string> printable_characters(std::string_view text);

/// The same as one string; cut after `limit` characters, with "..." at the end.
[[nodiscard]] std::string printable(std::string_view text, std::size_t limit);

/// Width of a screen that texts and tables for people fit on; results.txt has the same text.
inline constexpr std::size_t screen_columns = 80;

/// A paragraph in lines of at most `columns` characters, broken at single spaces. Lines after the first begin with
/// `indent` spaces. A longer word has a line of its own. Ends without a line end.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent);

/// A name or value for messages: printable, in single quotes, at most 60 characters.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// A text as Python and C++ read it: in double quotes, with a backslash before '"' and '\\', control characters as
/// three octal digits. Other bytes stay as they are.
[[nodiscard]] std::string string_literal(std::string_view text);

/// "-6.0871 +- 0.0012": the error with two digits, the mean with as many decimals. If the error is 0 or unknown, the
/// mean alone with six digits.
[[nodiscard]] std::string with_error(double mean, double error);

/// A text without leading and trailing spaces and tabs.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// A whole text as a number, "0.85" or "1e-3", without leading blank or plus sign; empty if it is no number, not finite
/// or out of range.
[[nodiscard]] std::optional<double> to_number(std::string_view text);

/// Line number `line` (from 1) of `text` without its line end ("\n" or "\r\n"); empty if there is no such line.
[[nodiscard]] std::string_view line_of(std::string_view text, int line);

}  // namespace ljmd
