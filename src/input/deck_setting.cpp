#include "input/deck_setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "input/toml_text.hpp"

namespace ljmd {
namespace {

constexpr std::size_t max_keys = 32;

constexpr std::string_view setting_source = "--set ";
constexpr std::string_view value_lead = "value = ";  // turns a value into TOML

/// Move a value and its parts to the location of the setting, each with its own column. So a key that is set has
/// another location than a default (see Section::written).
void relocate(Value& value, const Location& setting, int shift) {
    const auto place = [&](const Location& found) { return Location{setting.source, 0, found.column + shift}; };
    value.location = place(value.location);
    if (auto* array = std::get_if<Array>(&value.data)) {
        for (Value& element : *array) relocate(element, setting, shift);
    } else if (auto* table = std::get_if<Table>(&value.data)) {
        for (Entry& entry : *table) {
            entry.key_location = place(entry.key_location);
            relocate(entry.value, setting, shift);
        }
    }
}

/// The value of a setting: TOML, or else the text itself. Nothing, with an error, for TOML that cannot be used.
/// @param column  at which the text begins
std::optional<Value> read_value(const std::string& text, const Location& setting, int column,
                                Diagnostics& diagnostics) {
    Diagnostics mistakes;
    auto table = parse_toml(std::make_shared<const Source>(Source{"", std::string(value_lead) + text}), mistakes);
    if (table && table->size() == 1) {
        relocate(table->front().value, setting, column - static_cast<int>(value_lead.size()) - 1);
        return std::move(table->front().value);
    }
    if (!table && !mistakes.entries().front().message.starts_with("not valid TOML")) {
        diagnostics.error(setting, mistakes.entries().front().message);
        return std::nullopt;
    }
    return Value{text, {setting.source, 0, column}};
}

/// Warn that the value of an earlier setting has no effect.
void warn_of_earlier_setting(const Entry& entry, const Location& setting, Diagnostics& diagnostics) {
    const Location& earlier = entry.key_location;
    if (earlier.source && earlier.source->name.starts_with(setting_source)) {
        diagnostics.warning(earlier, fmt::format("has no effect: {} comes after it", setting.source->name));
    }
}

/// The tables of an array, and those that have a name.
struct Elements {
    std::vector<Table*> tables;
    std::vector<std::pair<std::string, Table*>> names;

    /// How a setting selects them, as a hint.
    [[nodiscard]] std::string reached(const std::string& key) const {
        if (tables.empty()) return fmt::format("it is set as a whole: {}=[...]", key);
        if (names.empty()) return fmt::format("its elements are reached by number: {}.1.KEY=VALUE", key);
        return fmt::format("its elements are reached by name: {}.NAME.KEY=VALUE", key);
    }
};

Elements elements_of(Array& array) {
    Elements elements;
    for (Value& value : array) {
        auto* table = std::get_if<Table>(&value.data);
        if (!table) continue;
        elements.tables.push_back(table);
        const Entry* entry = find(*table, element_name);
        const auto* name = entry ? std::get_if<std::string>(&entry->value.data) : nullptr;
        if (name) elements.names.emplace_back(*name, table);
    }
    return elements;
}

Table* named_element(const Elements& elements, const std::string& key, const std::string& name, const Location& where,
                     Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (const auto& [known, table] : elements.names) {
        if (known == name) return table;
        names.push_back(known);
    }
    const std::string nearest = nearest_name(name, names);
    const std::string known = fmt::format("known names: {}", fmt::join(names, ", "));
    diagnostics.error(where, fmt::format("no {} is named {}", in_quotes(key), in_quotes(name)),
                      nearest.empty() ? known : fmt::format("did you mean '{}'? {}", nearest, known));
    return nullptr;
}

Table* numbered_element(const Elements& elements, const std::string& key, const std::string& text,
                        const Location& where, Diagnostics& diagnostics) {
    std::size_t number = 0;  // stays 0 when the number is out of range
    const char* end = std::from_chars(text.data(), text.data() + text.size(), number).ptr;
    const std::size_t count = elements.tables.size();
    if (end != text.data() + text.size()) {
        diagnostics.error(where, fmt::format("no {} is named {}", in_quotes(key), in_quotes(text)),
                          elements.reached(key));
    } else if (number < 1 || number > count) {
        diagnostics.error(where, fmt::format("no {} has the number {}", in_quotes(key), text),
                          fmt::format("there {} {} [[{}]] table{}, counted from 1", count == 1 ? "is" : "are", count,
                                      key, count == 1 ? "" : "s"));
    } else {
        return elements.tables[number - 1];
    }
    return nullptr;
}

/// The table that holds the last of `keys`, created if missing. Null, with an error, if the path leads through
/// something that is not a table.
Table* descend(Table& root, const std::vector<std::string>& keys, const Location& where, Diagnostics& diagnostics) {
    Table* here = &root;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        Entry* entry = find(*here, keys[i]);
        if (!entry) {
            here->push_back({keys[i], where, Value{Table{}, where}});
            entry = &here->back();
        }
        if (auto* table = std::get_if<Table>(&entry->value.data)) {
            here = table;
            continue;
        }
        auto* array = std::get_if<Array>(&entry->value.data);
        const Elements elements = array ? elements_of(*array) : Elements{};
        if (elements.tables.empty() || i + 2 == keys.size()) {
            diagnostics.error(where, fmt::format("{} is {}, not a table", in_quotes(keys[i]), kind_name(entry->value)),
                              array ? elements.reached(keys[i]) : "");
            return nullptr;
        }
        const auto element = elements.names.empty() ? numbered_element : named_element;
        here = element(elements, keys[i], keys[i + 1], where, diagnostics);
        if (!here) return nullptr;
        ++i;
    }
    return here;
}

}  // namespace

std::vector<std::string> setting_key(const std::string& text) {
    std::vector<std::string> parts(1);
    char quote = '\0';
    for (const char c : text) {
        if (quote != '\0') {
            if (c == quote) {
                quote = '\0';
            } else {
                parts.back() += c;
            }
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '.') {
            parts.emplace_back();
        } else if (c != ' ' && c != '\t') {
            parts.back() += c;
        }
    }
    const bool has_gap = std::any_of(parts.begin(), parts.end(), [](const std::string& part) { return part.empty(); });
    return has_gap || quote != '\0' ? std::vector<std::string>{} : parts;
}

void apply_setting(Table& table, const std::string& assignment, Diagnostics& diagnostics) {
    const Location where{std::make_shared<const Source>(Source{std::string(setting_source) + assignment, assignment})};
    if (find_invalid_utf8(assignment) != std::string::npos) {
        diagnostics.error(where, "invalid UTF-8");
        return;
    }
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        diagnostics.error(where, "a setting has the form KEY=VALUE");
        return;
    }
    const std::vector<std::string> keys = setting_key(assignment.substr(0, equals));
    if (keys.empty() || keys.size() > max_keys) {
        diagnostics.error(where, keys.empty() ? "the key, or a part of it, is empty" : "the key has too many parts");
        return;
    }
    auto value = read_value(assignment.substr(equals + 1), where, static_cast<int>(equals) + 2, diagnostics);
    if (!value) return;
    Table* holder = descend(table, keys, where, diagnostics);
    if (!holder) return;
    if (Entry* entry = find(*holder, keys.back())) {
        warn_of_earlier_setting(*entry, where, diagnostics);
        *entry = {keys.back(), where, std::move(*value)};
    } else {
        holder->push_back({keys.back(), where, std::move(*value)});
    }
}

}  // namespace ljmd
