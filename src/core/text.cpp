#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/number_text.hpp"
#include "core/terminal_text.hpp"

namespace ljmd {

std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0u) == 0x80u; };
    const unsigned first = byte(0);
    if (text.empty()) return 0;
    if (first < 0x80u) return 1;
    if (first >= 0xC2u && first <= 0xDFu) return continues(1) ? 2 : 0;
    if (first >= 0xE0u && first <= 0xEFu) {
        const bool overlong = first == 0xE0u && byte(1) < 0xA0u;
        const bool surrogate = first == 0xEDu && byte(1) > 0x9Fu;
        return continues(1) && continues(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0u && first <= 0xF4u) {
        const bool overlong = first == 0xF0u && byte(1) < 0x90u;
        const bool beyond_unicode = first == 0xF4u && byte(1) > 0x8Fu;
        return continues(1) && continues(2) && continues(3) && !overlong && !beyond_unicode ? 4 : 0;
    }
    return 0;
}

std::size_t find_invalid_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t length = utf8_length(text.substr(i));
        if (length == 0) return i;
        i += length;
    }
    return std::string_view::npos;
}

std::vector<std::string> printable_characters(std::string_view text) {
    std::vector<std::string> characters;
    while (!text.empty()) {
        const std::size_t length = harmless_length(text);
        if (length > 0) {
            characters.emplace_back(text.substr(0, length));
        } else {
            characters.emplace_back(text[0] == '\t' ? " " : "?");
        }
        text.remove_prefix(std::max<std::size_t>(utf8_length(text), 1));
    }
    return characters;
}

std::string printable(std::string_view text, std::size_t limit) {
    // A character has at most four bytes, so the rest of a long text need not be split.
    const auto characters = printable_characters(text.substr(0, 4 * (limit + 1)));
    std::string shown;
    for (std::size_t i = 0; i < characters.size() && i < limit; ++i) shown += characters[i];
    return characters.size() > limit ? shown + "..." : shown;
}

std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent) {
    std::string lines;
    std::size_t length = 0;  // of the last line
    bool begun = false;      // the last line has a word
    while (!text.empty()) {
        // Spaces before a word belong to it where the line begins with them.
        const std::size_t blanks = std::min(text.find_first_not_of(' '), text.size());
        const std::size_t end = std::min(text.find(' ', blanks), text.size());
        const std::size_t word = printable_characters(text.substr(0, end)).size();
        if (begun && length + word > columns) {
            lines += '\n' + std::string(indent, ' ');
            lines += text.substr(blanks, end - blanks);
            length = indent + word - blanks;
        } else {
            lines += text.substr(0, end);
            length += word;
        }
        begun = true;
        text.remove_prefix(end);
    }
    return lines;
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t max_characters = 60;
    return "'" + printable(text, max_characters) + "'";
}

std::string string_literal(std::string_view text) {
    std::string literal = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 32 || byte == 127) {
            literal += fmt::format("\\{:03o}", byte);
            continue;
        }
        literal += c == '"' || c == '\\' ? "\\" : "";
        literal += c;
    }
    return literal + "\"";
}

std::string with_error(double mean, double error) {
    if (!(error > 0.0) || !std::isfinite(error)) {
        return without_negative_zero(fmt::format("{:.6g}", mean));
    }
    constexpr int max_decimals = 12;
    constexpr int all_digits = 15;  // of a double
    const auto power_of = [](double x) { return static_cast<int>(std::floor(std::log10(x))); };
    const int decimals = std::max(1 - power_of(error), 0);
    if (decimals <= max_decimals) {
        return without_negative_zero(fmt::format("{:.{}f} +- {:.{}f}", mean, decimals, error, decimals));
    }
    // So small an error would be rounded to 0.
    const bool has_digits = std::isfinite(mean) && mean != 0.0;
    const int digits = has_digits ? std::clamp(power_of(std::abs(mean)) + decimals + 1, 1, all_digits) : 1;
    return fmt::format("{:.{}g} +- {:.2g}", without_negative_zero(mean), digits, error);
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t";
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::optional<double> to_number(std::string_view text) {
    double value = 0.0;
    const char* all = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), all, value);
    return error == std::errc() && end == all && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::string_view line_of(std::string_view text, int line) {
    for (int skipped = 1; skipped < line; ++skipped) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    if (text.ends_with('\r')) text.remove_suffix(1);
    return text;
}

}  // namespace ljmd
