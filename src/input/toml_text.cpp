#include "input/toml_text.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "core/text.hpp"

namespace ljmd {
namespace {

constexpr int max_depth = 32;

std::size_t count_characters(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); ++count) text.remove_prefix(std::max<std::size_t>(utf8_length(text), 1));
    return count;
}

Location at_offset(const std::shared_ptr<const Source>& source, std::size_t offset) {
    const auto before = std::string_view(source->text).substr(0, offset);
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return {source, 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n')),
            1 + static_cast<int>(count_characters(before.substr(line_start))), 1};
}

/// The end of the string literal that begins at `start`: after its closing quotes, or at the end of its line.
std::size_t skip_string(std::string_view text, std::size_t start) {
    const char quote = text[start];
    const bool multi_line = text.substr(start).starts_with(std::string(3, quote));
    const std::string closing(multi_line ? 3 : 1, quote);
    for (std::size_t i = start + closing.size(); i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (text.substr(i).starts_with(closing)) {
            i += closing.size();
            // A multi-line string may end in up to two quotes of its own.
            for (int more = 0; multi_line && more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
            return i;
        } else if (text[i] == '\n' && !multi_line) {
            return i;
        }
    }
    return text.size();
}

/// The position where brackets are nested, or a dotted key grows, deeper than max_depth; npos if there is none. The
/// parser and all functions on its trees recurse; the limit protects the stack.
std::size_t find_too_deep(std::string_view text) {
    int depth = 0;
    int dots = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        switch (text[i]) {
            case '#':
                i = std::min(text.find('\n', i), text.size());
                dots = 0;
                break;
            case '"':
            case '\'':
                i = skip_string(text, i) - 1;
                break;
            case '[':
            case '{':
                ++depth;
                dots = 0;
                break;
            case ']':
            case '}':
                depth = std::max(depth - 1, 0);
                dots = 0;
                break;
            case '.':
                ++dots;
                break;
            case '=':
            case ',':
            case '\n':
                dots = 0;
                break;
            default:
                break;
        }
        if (depth > max_depth || dots >= max_depth) return i;
    }
    return std::string_view::npos;
}

/// A syntax error of toml++, reworded for decks.
struct Mistake {
    std::string message;
    std::string hint;
    std::string token;  ///< what to underline on the line, if it can be found there
};

std::string between_quotes(std::string_view text) {
    const std::size_t first = text.find('\'');
    const std::size_t last = text.rfind('\'');
    return first < last && last != std::string_view::npos ? std::string(text.substr(first + 1, last - first - 1)) : "";
}

void replace(std::string& text, std::string_view old_words, std::string_view new_words) {
    if (const std::size_t at = text.find(old_words); at != std::string::npos) {
        text.replace(at, old_words.size(), new_words);
    }
}

Mistake in_own_words(std::string_view description, bool at_line_end) {
    constexpr std::string_view prefix = "Error while parsing ";
    if (description.starts_with(prefix)) description.remove_prefix(prefix.size());
    const std::size_t colon = std::min(description.find(": "), description.size());
    const std::string scope(description.substr(0, colon));
    std::string reason(description.substr(std::min(colon + 2, description.size())));
    const std::string token = between_quotes(reason);

    // toml++ has one sentence or the other for a number like 1e400, as the standard library can read numbers or not.
    const bool is_integer = scope.ends_with("integer");
    if (is_integer && reason.ends_with("is not representable in 64 bits"))
        return {"'" + token + "' does not fit in 64 bits", "", token};
    if (reason.ends_with("could not be interpreted as a value") || reason.ends_with("is not representable in 64 bits"))
        return {"'" + token + "' is too large for a number", "", token};
    if (reason.starts_with("cannot redefine existing") && !token.empty() && reason.ends_with("'")) {
        return {(scope == "table header" ? "table '" : "key '") + token + "' is given twice", "", token};
    }
    for (const char* like : {"expected 'true'", "expected 'false'", "expected 'inf'", "expected 'nan'"}) {
        // A bare word that begins like one of these, such as fcc.
        if (reason.starts_with(like)) reason = "could not determine value type";
    }
    std::string hint;
    if (reason.find("could not determine value type") == 0) hint = "text needs quotes";
    if (reason.find("expected a comment") == 0 && scope == "key-value pair") hint = "text and units need quotes";
    if (reason.find("control characters") != std::string::npos) {
        reason = at_line_end ? "a string must end on its line" : "control characters are not allowed";
    }
    replace(reason, "encountered end-of-file", "the text ends within this " + scope);
    replace(reason, "this floating-point", "this number");
    replace(reason, "could not determine value type", "this is no value");
    replace(reason, "expected a comment or whitespace", "expected the end of the line");
    replace(reason, "expected keys, tables, whitespace or comments", "expected a key or a [table]");
    replace(reason, "saw '\\n'", "saw the end of the line");
    return {"not valid TOML: " + reason, hint, ""};
}

void report(const toml::parse_error& error, const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
    const auto begin = error.source().begin;
    Location where{source, static_cast<int>(begin.line), static_cast<int>(begin.column), 1};
    const std::string_view line = line_of(source->text, where.line);
    const Mistake mistake =
        in_own_words(error.description(), static_cast<std::size_t>(where.column) > count_characters(line));
    // toml++ stops at the start of a header, or after a key or number: the token is the last one before that, if any.
    std::size_t byte = 0;
    for (int column = 1; column < where.column && byte < line.size(); ++column) {
        byte += std::max<std::size_t>(utf8_length(line.substr(byte)), 1);
    }
    std::size_t at = line.substr(0, byte).rfind(mistake.token);
    if (at == std::string_view::npos) at = line.find(mistake.token);
    if (!mistake.token.empty() && at != std::string_view::npos) {
        where.column = 1 + static_cast<int>(count_characters(line.substr(0, at)));
        where.length = static_cast<int>(count_characters(mistake.token));
    }
    diagnostics.error(where, mistake.message, mistake.hint);
}

/// Converts toml++'s tree into ours.
class Converter {
  public:
    explicit Converter(std::shared_ptr<const Source> source) : source_(std::move(source)) {}

    [[nodiscard]] Table table(const toml::table& from) const {
        std::vector<std::pair<const toml::key*, const toml::node*>> entries;
        for (const auto& [key, node] : from) entries.emplace_back(&key, &node);
        std::sort(entries.begin(), entries.end(),
                  [](const auto& a, const auto& b) { return a.first->source().begin < b.first->source().begin; });
        Table into;
        for (const auto& [key, node] : entries) {
            into.push_back({std::string(key->str()), location(key->source()), value(*node)});
        }
        return into;
    }

  private:
    [[nodiscard]] Location location(const toml::source_region& region) const {
        const bool one_line = region.begin.line == region.end.line && region.begin.column < region.end.column;
        return {source_, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column),
                one_line ? static_cast<int>(region.end.column - region.begin.column) : 1};
    }

    [[nodiscard]] Value value(const toml::node& node) const {
        const Location where = location(node.source());
        if (const auto* flag = node.as_boolean()) return {flag->get(), where};
        if (const auto* integer = node.as_integer()) return {integer->get(), where};
        if (const auto* number = node.as_floating_point()) return {number->get(), where};
        if (const auto* text = node.as_string()) return {text->get(), where};
        if (const auto* inner = node.as_table()) return {table(*inner), where};
        if (const auto* array = node.as_array()) {
            Array elements;
            for (const toml::node& element : *array) elements.push_back(value(element));
            return {std::move(elements), where};
        }
        std::ostringstream text;
        if (const auto* date = node.as_date()) text << *date;
        if (const auto* time = node.as_time()) text << *time;
        if (const auto* date_time = node.as_date_time()) text << *date_time;
        return {Date{text.str()}, where};
    }

    std::shared_ptr<const Source> source_;
};

}  // namespace

std::optional<Table> parse_toml(const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
    const std::string& text = source->text;
    if (const std::size_t bad = std::min(find_invalid_utf8(text), text.find('\0')); bad != std::string::npos) {
        diagnostics.error(at_offset(source, bad), text[bad] == '\0' ? "binary data (a NUL byte)" : "invalid UTF-8",
                          "a deck is plain text in UTF-8");
        return std::nullopt;
    }
    if (const std::size_t deep = find_too_deep(text); deep != std::string::npos) {
        diagnostics.error(at_offset(source, deep), "nested deeper than " + std::to_string(max_depth) + " levels");
        return std::nullopt;
    }
    try {
        return Converter(source).table(toml::parse(text));
    } catch (const toml::parse_error& error) {
        report(error, source, diagnostics);
        return std::nullopt;
    }
}

}  // namespace ljmd
