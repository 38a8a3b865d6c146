#include "ljmd/options/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <type_traits>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/section.hpp"

namespace ljmd {

namespace {

Value value_of(const PlainValue& plain) {
    Value value;
    std::visit(
        [&value](const auto& any) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(any)>, std::vector<double>>) {
                Array array;
                for (const double number : any) {
                    array.push_back({number, {}});
                }
                value.data = array;
            } else {
                value.data = any;
            }
        },
        plain);
    return value;
}

}  // namespace

std::string settings_in_words(const Settings& settings) {
    std::string text;
    for (const auto& [key, value] : settings) {
        text += text.empty() ? "" : " ";
        text += std::visit([&key = key](const auto& any) { return fmt::format("{}={}", key, any); }, value);
    }
    return text;
}

void append(const Settings& settings, Table& table) {
    for (const auto& [key, value] : settings) {
        table.push_back({key, {}, value_of(value)});
    }
}

Section checked_settings(const std::string& title, const std::vector<Key>& keys, const Settings& settings) {
    std::set<std::string> given;
    for (const auto& [key, value] : settings) {
        if (!given.insert(key).second) {
            throw InputError(fmt::format("'{}' in {} is given twice", key, title));
        }
    }
    Table table;
    append(settings, table);
    Diagnostics diagnostics;
    Section section = validate(table, {}, Schema(title, keys), std::nullopt, diagnostics);
    if (diagnostics.has_errors()) {
        throw InputError(diagnostics.errors_without_places());
    }
    return section;
}

}  // namespace ljmd
