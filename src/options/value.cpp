#include "ljmd/detail/options/value.hpp"

#include <algorithm>

namespace ljmd {

const Entry* find(const Table& table, const std::string& key) {
    const auto entry =
        std::find_if(table.begin(), table.end(), [&](const Entry& candidate) { return candidate.key == key; });
    return entry == table.end() ? nullptr : &*entry;
}

Entry* find(Table& table, const std::string& key) {
    const auto entry =
        std::find_if(table.begin(), table.end(), [&](const Entry& candidate) { return candidate.key == key; });
    return entry == table.end() ? nullptr : &*entry;
}

std::string kind_name(const Value& value) {
    struct Name {
        std::string operator()(bool) const { return "a boolean"; }
        std::string operator()(std::int64_t) const { return "an integer"; }
        std::string operator()(double) const { return "a float"; }
        std::string operator()(const std::string&) const { return "a string"; }
        std::string operator()(const Array&) const { return "an array"; }
        std::string operator()(const Table&) const { return "a table"; }
        std::string operator()(const Date&) const { return "a date"; }
    };
    return std::visit(Name{}, value.data);
}

}  // namespace ljmd
