#include "input/toml_mistake.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <vector>

#include "core/text.hpp"
#include "input/toml_scan.hpp"

namespace ljmd {

namespace {

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '+' || c == '.';
}

/// What lies open at a place of a text: brackets, and where the string begins that the place is in.
struct Open {
    std::vector<char> brackets;
    std::optional<std::size_t> string;
};

Open open_at(std::string_view text, std::size_t end) {
    Open open;
    for (std::size_t i = 0; i < end;) {
        const char c = text[i];
        if (c == '#') {
            i = std::min(text.find('\n', i), end);
        } else if (c == '"' || c == '\'') {
            const std::size_t after = skip_string(text, i);
            const bool has_end = after > i + 1 && text[after - 1] == c;
            open.string = after > end || (after == end && !has_end) ? std::optional(i) : std::nullopt;
            i = after;
        } else {
            if (c == '[' || c == '{') {
                open.brackets.push_back(c);
            } else if ((c == ']' || c == '}') && !open.brackets.empty()) {
                open.brackets.pop_back();
            }
            ++i;
        }
    }
    return open;
}

/// The text about the place where a parser stopped.
class Place {
  public:
    Place(std::string_view text, std::size_t stopped)
        : text_(text),
          stopped_(std::min(stopped, text.size())),
          line_begin_(stopped_ == 0 ? 0 : text.rfind('\n', stopped_ - 1) + 1),  // npos + 1 is 0
          before_(text.substr(line_begin_, stopped_ - line_begin_)),
          after_(text.substr(stopped_, std::min(text.find('\n', stopped_), text.size()) - stopped_)),
          line_(text.substr(line_begin_, before_.size() + after_.size())),
          begun_(trimmed(before_)) {}

    [[nodiscard]] TomlMistake mistake(std::string_view words) const {
        for (const auto rule : {&Place::lone_return, &Place::number, &Place::open_string, &Place::control_character,
                                &Place::missing_value, &Place::bare_word, &Place::twice, &Place::more_than_a_value,
                                &Place::open_bracket, &Place::no_key}) {
            if (auto found = (this->*rule)()) {
                return *found;
            }
        }
        return {fmt::format("not valid TOML: {}", printable(words, longest_words))};
    }

  private:
    static constexpr std::size_t longest_words = 200;

    [[nodiscard]] TomlMistake at_token(std::string message, std::string_view token) const {
        return {std::move(message), "", offset_of(token), token.size()};
    }

    [[nodiscard]] TomlMistake expected(std::string_view what, std::string hint = {}) const {
        const std::size_t length = std::max<std::size_t>(utf8_length(after_), 1);
        const std::string seen = after_.empty()
                                     ? stopped_ == text_.size() ? "the end of the text" : "the end of the line"
                                     : fmt::format("'{}'", printable(after_.substr(0, length), length + 8));
        return {fmt::format("not valid TOML: expected {}, saw {}", what, seen), std::move(hint)};
    }

    /// The word that ends at a place, is there, or begins there.
    [[nodiscard]] std::string_view word_at(std::size_t place) const {
        std::size_t begin = place;
        while (begin > line_begin_ && is_word(text_[begin - 1])) {
            --begin;
        }
        std::size_t end = begin;
        while (end < text_.size() && is_word(text_[end])) {
            ++end;
        }
        return text_.substr(begin, end - begin);
    }
    [[nodiscard]] std::string_view word() const { return word_at(stopped_); }

    [[nodiscard]] std::size_t offset_of(std::string_view part) const {
        return static_cast<std::size_t>(part.data() - text_.data());
    }

    /// The key that the parser has read last, or its value: that before the '=' behind which it stopped, or before
    /// which.
    [[nodiscard]] std::string_view last_key() const {
        std::string_view key = begun_;
        if (key.ends_with('=')) {
            key = trimmed(key.substr(0, key.size() - 1));
        } else if (!trimmed(text_.substr(offset_of(word()) + word().size())).starts_with('=')) {
            return {};
        }
        return key.empty() ? word() : word_at(offset_of(key) + key.size());
    }

    [[nodiscard]] bool is_header() const { return trimmed(line_).starts_with('['); }
    [[nodiscard]] bool begins_value() const {
        return begun_.ends_with('=') || ((begun_.ends_with(',') || begun_.ends_with('[')) && !is_header());
    }

    /// Old Mac files end their lines by carriage returns alone.
    [[nodiscard]] std::optional<TomlMistake> lone_return() const {
        const bool is_lone = stopped_ > 0 && text_[stopped_ - 1] == '\r' && !after_.empty();
        return is_lone ? std::optional(TomlMistake{"not valid TOML: a carriage return alone ends no line"})
                       : std::nullopt;
    }

    /// A parser stops at a header that stood before, or at a key that did, or at its value.
    [[nodiscard]] std::optional<TomlMistake> twice() const { return is_header() ? header_twice() : key_twice(); }

    [[nodiscard]] std::optional<TomlMistake> header_twice() const {
        const std::string_view earlier = text_.substr(0, line_begin_);
        const std::string_view header = trimmed(line_);
        const std::string_view name = trimmed(header.substr(1, header.find(']') - 1));
        if (!header.ends_with(']') || name.starts_with('[')) {
            return std::nullopt;
        }
        for (std::size_t at = earlier.find(header); at != std::string_view::npos; at = earlier.find(header, at + 1)) {
            const std::size_t begin = at == 0 ? 0 : earlier.rfind('\n', at - 1) + 1;
            if (trimmed(earlier.substr(begin, at - begin)).empty()) {
                return at_token(fmt::format("table '{}' is given twice", name), name);
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<TomlMistake> key_twice() const {
        const std::string_view key = last_key();
        if (key.empty()) {
            return std::nullopt;
        }
        const std::size_t header = text_.substr(0, line_begin_).rfind("\n[");
        const std::size_t table = header != std::string_view::npos ? header : 0;
        for (std::size_t at = text_.find(key, table); at < offset_of(key); at = text_.find(key, at + 1)) {
            const bool whole = at == 0 || !is_word(text_[at - 1]);
            if (whole && trimmed(text_.substr(at + key.size())).starts_with('=')) {
                return at_token(fmt::format("key '{}' is given twice", key), key);
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<TomlMistake> number() const {
        std::string_view token = word();
        if (token.empty() || is_header()) {
            return std::nullopt;
        }
        std::string digits(token);
        std::erase(digits, '_');
        const std::size_t sign = digits.front() == '-' || digits.front() == '+' ? 1 : 0;
        if (sign == digits.size() || std::isdigit(static_cast<unsigned char>(digits[sign])) == 0) {
            return std::nullopt;
        }
        if (digits.find_first_not_of("0123456789", sign) == std::string::npos) {
            std::int64_t value = 0;
            const char* end = digits.data() + digits.size();
            const char* begin = digits.data() + (digits.front() == '+' ? 1 : 0);
            if (std::from_chars(begin, end, value).ec == std::errc::result_out_of_range) {
                return at_token(fmt::format("'{}' does not fit in 64 bits", token), token);
            }
            return std::nullopt;
        }
        char* end = nullptr;
        const double value = std::strtod(digits.c_str(), &end);
        if (end == digits.c_str() + digits.size() && std::isinf(value)) {
            token.remove_prefix(sign);
            return at_token(fmt::format("'{}' is too large for a number", token), token);
        }
        if (end == digits.c_str() + digits.size() && digits.back() == '.') {
            return at_token("not valid TOML: a digit must follow the point of a number", token);
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<TomlMistake> open_string() const {
        const Open open = open_at(text_, stopped_);
        if (!open.string || !after_.empty()) {
            return std::nullopt;
        }
        const bool many_lines =
            text_.substr(*open.string).starts_with("\"\"\"") || text_.substr(*open.string).starts_with("'''");
        return TomlMistake{many_lines ? "not valid TOML: the text ends within this string"
                                      : "not valid TOML: a string must end on its line"};
    }

    [[nodiscard]] std::optional<TomlMistake> control_character() const {
        const bool is_control = !after_.empty() && after_.front() != '\t' && after_.front() != '\r' &&
                                std::iscntrl(static_cast<unsigned char>(after_.front())) != 0;
        return is_control ? std::optional(TomlMistake{"not valid TOML: control characters are not allowed"})
                          : std::nullopt;
    }

    [[nodiscard]] std::optional<TomlMistake> missing_value() const {
        const bool is_missing = after_.empty() && begun_.ends_with('=') && begun_.size() > 1;
        return is_missing ? std::optional(expected("value")) : std::nullopt;
    }

    /// Text without quotes, such as fcc or trap.
    [[nodiscard]] std::optional<TomlMistake> bare_word() const {
        const std::string_view token = word();
        const auto begin = offset_of(token);
        const Place there(text_, begin);
        const bool is_bare = !token.empty() && std::isalpha(static_cast<unsigned char>(token.front())) != 0 &&
                             there.begins_value() && there.begun_.size() > 1;
        return is_bare ? std::optional(TomlMistake{"not valid TOML: this is no value", "text needs quotes", begin, 1})
                       : std::nullopt;
    }

    [[nodiscard]] std::optional<TomlMistake> more_than_a_value() const {
        if (after_.empty() || !open_at(text_, stopped_).brackets.empty()) {
            return std::nullopt;
        }
        if (is_header()) {
            return begun_.ends_with(']') ? std::optional(expected("the end of the line")) : std::nullopt;
        }
        const std::size_t equals = before_.find('=');
        const bool has_value =
            equals != std::string_view::npos && equals > 0 && !trimmed(before_.substr(equals + 1)).empty();
        const bool has_escape = has_value && open_at(text_, stopped_).string;
        return has_value && !has_escape ? std::optional(expected("the end of the line", "text and units need quotes"))
                                        : std::nullopt;
    }

    [[nodiscard]] std::optional<TomlMistake> open_bracket() const {
        const Open open = open_at(text_, stopped_);
        if (open.brackets.empty() || !after_.empty()) {
            return std::nullopt;
        }
        const bool is_array = open.brackets.back() == '[' && !is_header();
        if (is_array && text_.find_first_not_of(" \t\r\n", stopped_) == std::string_view::npos) {
            return TomlMistake{"not valid TOML: the text ends within this array"};
        }
        return expected(open.brackets.back() == '[' ? "']'" : "'}'");
    }

    /// A line that begins with no key, or with one that no '=' follows.
    [[nodiscard]] std::optional<TomlMistake> no_key() const {
        if (is_header() || before_.find('=') != std::string_view::npos || !open_at(text_, stopped_).brackets.empty()) {
            return std::nullopt;
        }
        return begun_.empty() ? expected("a key or a [table]") : expected("'='");
    }

    std::string_view text_;
    std::size_t stopped_;
    std::size_t line_begin_;
    std::string_view before_;  ///< on the line
    std::string_view after_;   ///< on the line
    std::string_view line_;
    std::string_view begun_;  ///< what is before, without blanks around it
};

}  // namespace

TomlMistake toml_mistake(std::string_view text, std::size_t stopped, std::string_view words) {
    return Place(text, stopped).mistake(words);
}

}  // namespace ljmd
