#include "input/deck_reference.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ljmd {
namespace {

/// A cell of a Markdown table: one line, with every '|' escaped.
std::string cell(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|') escaped += '\\';
        escaped += c == '\n' ? ' ' : c;
    }
    return escaped;
}

std::string unit_cell(const Key& key) {
    const std::string names = unit_names(key.physical_dimension);
    if (key.reduced_unit.empty() || names.empty()) return key.reduced_unit + names;
    return fmt::format("{}; or in quotes {}", key.reduced_unit, names);
}

std::string allowed_cell(const Key& key) {
    if (key.kind == Kind::flag) return "true or false";
    return key.allowed();
}

std::string default_cell(const Key& key) {
    if (key.required) return "required";
    if (!key.default_value) return key.absent_text.empty() ? "none" : key.absent_text;
    struct Text {
        std::string operator()(bool value) const { return value ? "true" : "false"; }
        std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
        std::string operator()(double value) const { return fmt::format("{}", value); }
        std::string operator()(const std::string& value) const { return fmt::format("\"{}\"", value); }
        std::string operator()(const std::vector<double>& value) const {
            return fmt::format("[{}]", fmt::join(value, ", "));
        }
    };
    return std::visit(Text{}, *key.default_value);
}

std::string rows(const std::vector<Key>& keys) {
    std::string text = "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
    for (const Key& key : keys) {
        text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", cell(key.name), key.type(), cell(unit_cell(key)),
                            cell(allowed_cell(key)), cell(default_cell(key)), cell(key.meaning_text));
    }
    return text;
}

}  // namespace

std::string schema_markdown(const Schema& schema, int heading_level) {
    std::string page =
        fmt::format("{} `{}`\n\n", std::string(static_cast<std::size_t>(heading_level), '#'), schema.title());
    page += rows(schema.keys());
    for (const auto& selection : schema.selections()) {
        for (const auto& [choice, keys] : selection.cases) {
            if (!keys.empty())
                page += fmt::format("\nOnly with `{} = \"{}\"`:\n\n{}", selection.key, choice, rows(keys));
        }
    }
    for (const Key& key : schema.keys()) {
        for (const Schema& inner : key.inner) page += "\n" + schema_markdown(inner, std::min(heading_level + 1, 6));
    }
    return page;
}

}  // namespace ljmd
