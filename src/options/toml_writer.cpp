#include "options/toml_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace ljmd {

namespace {

std::string toml_key(const std::string& key) {
    const auto is_bare = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    };
    return !key.empty() && std::ranges::all_of(key, is_bare) ? key : toml_string(key);
}

std::vector<std::string> assignments(const Table& table) {
    std::vector<std::string> all;
    all.reserve(table.size());
    for (const Entry& entry : table) {
        all.push_back(fmt::format("{} = {}", toml_key(entry.key), toml_value(entry.value)));
    }
    return all;
}

std::string in_lines(const Table& table) {
    return table.empty() ? "" : fmt::format("{}\n", fmt::join(assignments(table), "\n"));
}

bool is_array_of_tables(const Value& value) {
    const auto* array = std::get_if<Array>(&value.data);
    return array != nullptr && !array->empty() &&
           std::ranges::all_of(*array, [](const Value& item) { return std::holds_alternative<Table>(item.data); });
}

}  // namespace

std::string toml_string(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const bool control = static_cast<unsigned char>(c) < ' ' || c == '\x7f';
        quoted += control                 ? fmt::format("\\u{:04x}", static_cast<unsigned>(c))
                  : c == '"' || c == '\\' ? fmt::format("\\{}", c)
                                          : std::string(1, c);
    }
    return quoted + "\"";
}

std::string toml_value(const Value& value) {
    return std::visit(
        [](const auto& data) -> std::string {
            using T = std::remove_cvref_t<decltype(data)>;
            if constexpr (std::is_same_v<T, std::string>) {
                return toml_string(data);
            } else if constexpr (std::is_same_v<T, Date>) {
                return data.text;
            } else if constexpr (std::is_same_v<T, Table>) {
                return data.empty() ? "{}" : fmt::format("{{ {} }}", fmt::join(assignments(data), ", "));
            } else if constexpr (std::is_same_v<T, Array>) {
                std::vector<std::string> items(data.size());
                std::ranges::transform(data, items.begin(), toml_value);
                return fmt::format("[{}]", fmt::join(items, ", "));
            } else if constexpr (std::is_same_v<T, double>) {
                const std::string text = fmt::format("{}", data);
                return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
            } else {
                return fmt::format("{}", data);
            }
        },
        value.data);
}

std::string toml_document(const Table& table) {
    Table plain;
    std::string tables;
    for (const Entry& entry : table) {
        if (const auto* inner = std::get_if<Table>(&entry.value.data)) {
            tables += inner->empty() ? "" : fmt::format("\n[{}]\n{}", toml_key(entry.key), in_lines(*inner));
        } else if (is_array_of_tables(entry.value)) {
            for (const Value& item : std::get<Array>(entry.value.data)) {
                tables += fmt::format("\n[[{}]]\n{}", toml_key(entry.key), in_lines(std::get<Table>(item.data)));
            }
        } else {
            plain.push_back(entry);
        }
    }
    return in_lines(plain) + tables;
}

}  // namespace ljmd
