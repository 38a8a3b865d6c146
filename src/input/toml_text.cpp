#include "input/toml_text.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>
#include <string_view>

#include "core/text.hpp"
#include "input/toml_mistake.hpp"
#include "input/toml_scan.hpp"

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

void report(const toml::parse_error& error, const std::shared_ptr<const Source>& source, Diagnostics& diagnostics) {
    const auto begin = error.source().begin;
    Location where{source, static_cast<int>(begin.line), static_cast<int>(begin.column), 1};
    const std::string_view line = line_of(source->text, where.line);
    std::size_t byte = 0;
    for (int column = 1; column < where.column && byte < line.size(); ++column) {
        byte += std::max<std::size_t>(utf8_length(line.substr(byte)), 1);
    }
    const TomlMistake mistake = toml_mistake(
        source->text, static_cast<std::size_t>(line.data() - source->text.data()) + byte, error.description());
    if (mistake.length > 0) {
        where = at_offset(source, mistake.offset);
        where.length =
            static_cast<int>(count_characters(std::string_view(source->text).substr(mistake.offset, mistake.length)));
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
