#include "ljmd/io/deck_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <optional>
#include <system_error>
#include <vector>

#include "ljmd/core/text.hpp"
#include "ljmd/io/toml_text.hpp"

namespace ljmd {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 20;
constexpr std::size_t max_keys = 32;

/// The parts of a dotted key; a part in quotes may hold dots. Empty when a part is empty or a quote is left open.
std::vector<std::string> split_key(const std::string& text) {
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

/// A value and all its parts stand at one place.
void relocate(Value& value, const Location& where) {
    value.location = where;
    if (auto* array = std::get_if<Array>(&value.data)) {
        for (Value& element : *array) relocate(element, where);
    } else if (auto* table = std::get_if<Table>(&value.data)) {
        for (Entry& entry : *table) {
            entry.key_location = where;
            relocate(entry.value, where);
        }
    }
}

/// The value of a setting: TOML, or else the text itself. Empty, with an error, where TOML was meant but cannot be
/// used.
std::optional<Value> read_value(const std::string& text, const Location& where, Diagnostics& diagnostics) {
    Diagnostics mistakes;
    auto table = parse_toml(std::make_shared<const Source>(Source{"", "value = " + text}), mistakes);
    if (table && table->size() == 1) {
        relocate(table->front().value, where);
        return std::move(table->front().value);
    }
    if (!table && !mistakes.entries().front().message.starts_with("not valid TOML")) {
        diagnostics.error(where, mistakes.entries().front().message);
        return std::nullopt;
    }
    return Value{text, where};
}

Table* named_element(Array& array, const std::string& key, const std::string& name, const Location& where,
                     Diagnostics& diagnostics) {
    std::vector<std::string> names;
    for (Value& element : array) {
        auto* table = std::get_if<Table>(&element.data);
        const Entry* entry = table ? find(*table, "name") : nullptr;
        const auto* text = entry ? std::get_if<std::string>(&entry->value.data) : nullptr;
        if (text && *text == name) return table;
        if (text) names.push_back(*text);
    }
    const std::string nearest = nearest_name(name, names);
    const std::string known = names.empty() ? "" : fmt::format("known names: {}", fmt::join(names, ", "));
    diagnostics.error(where, fmt::format("no {} is named {}", in_quotes(key), in_quotes(name)),
                      nearest.empty() ? known : fmt::format("did you mean '{}'? {}", nearest, known));
    return nullptr;
}

/// The table that holds the last of `keys`, made if it is missing; null, with an error, where the way is blocked.
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
        } else if (auto* array = std::get_if<Array>(&entry->value.data); array && i + 2 < keys.size()) {
            here = named_element(*array, keys[i], keys[i + 1], where, diagnostics);
            ++i;
        } else {
            diagnostics.error(where, fmt::format("{} is {}, not a table", in_quotes(keys[i]), kind_name(entry->value)),
                              array ? fmt::format("its elements are reached by name: {}.NAME.KEY=VALUE", keys[i]) : "");
            return nullptr;
        }
        if (!here) return nullptr;
    }
    return here;
}

}  // namespace

DeckFile parse_deck(std::string name, std::string text, Diagnostics& diagnostics) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    DeckFile deck;
    deck.source = std::make_shared<const Source>(Source{std::move(name), std::move(text)});
    if (deck.source->text.size() > max_bytes) {
        diagnostics.error({deck.source}, "larger than 1 MiB, which no deck is");
        return deck;
    }
    auto table = parse_toml(deck.source, diagnostics);
    if (table && table->empty()) diagnostics.error({deck.source}, "the deck is empty");
    if (table) deck.table = std::move(*table);
    return deck;
}

DeckFile read_deck(const std::filesystem::path& path, Diagnostics& diagnostics) {
    const auto fail = [&](const std::string& message) {
        DeckFile none{std::make_shared<const Source>(Source{path.string(), ""}), {}};
        diagnostics.error({none.source}, message);
        return none;
    };
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found) return fail("no such file");
    if (error) return fail("cannot be read: " + error.message());
    if (std::filesystem::is_directory(status)) return fail("a directory, not a deck");
    if (!std::filesystem::is_regular_file(status)) return fail("not a regular file");
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    if (!file) return fail("cannot be read: " + std::generic_category().message(errno));
    // One byte more than allowed tells a text that is too large, whatever its size.
    std::string text(max_bytes + 4, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) return fail("cannot be read");
    text.resize(static_cast<std::size_t>(file.gcount()));
    return parse_deck(path.string(), std::move(text), diagnostics);
}

void apply_setting(Table& table, const std::string& assignment, Diagnostics& diagnostics) {
    const Location where{std::make_shared<const Source>(Source{"--set " + assignment, assignment})};
    if (find_invalid_utf8(assignment) != std::string::npos) {
        diagnostics.error(where, "invalid UTF-8");
        return;
    }
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        diagnostics.error(where, "a setting has the form KEY=VALUE");
        return;
    }
    const std::vector<std::string> keys = split_key(assignment.substr(0, equals));
    if (keys.empty() || keys.size() > max_keys) {
        diagnostics.error(where, keys.empty() ? "the key, or a part of it, is empty" : "the key has too many parts");
        return;
    }
    auto value = read_value(assignment.substr(equals + 1), where, diagnostics);
    if (!value) return;
    Table* holder = descend(table, keys, where, diagnostics);
    if (!holder) return;
    if (Entry* entry = find(*holder, keys.back())) {
        *entry = {keys.back(), where, std::move(*value)};
    } else {
        holder->push_back({keys.back(), where, std::move(*value)});
    }
}

}  // namespace ljmd
