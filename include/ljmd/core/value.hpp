#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "ljmd/core/diagnostics.hpp"

namespace ljmd {

struct Entry;
struct Value;

using Array = std::vector<Value>;
using Table = std::vector<Entry>;  ///< in the order of the text; keys are unique

/// A date or time of TOML as its text. It has no use in a deck; it is kept so that a message can name it.
struct Date {
    std::string text;
};

/// What a deck holds, format-neutral, every value with its place.
struct Value {
    std::variant<bool, std::int64_t, double, std::string, Array, Table, Date> data;
    Location location;
};

/// One `key = value` of a table.
struct Entry {
    std::string key;
    Location key_location;
    Value value;
};

/// The entry of that name, or nullptr.
[[nodiscard]] const Entry* find(const Table& table, const std::string& key);
[[nodiscard]] Entry* find(Table& table, const std::string& key);

/// "a string", "an integer", ...: how messages name what was found.
[[nodiscard]] std::string kind_name(const Value& value);

}  // namespace ljmd
