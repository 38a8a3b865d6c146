#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

struct Entry;
struct Value;

using Array = std::vector<Value>;
using Table = std::vector<Entry>;  ///< in the order of the text; keys are unique

/// A TOML date or time as text. Decks have no use for it; it is kept so that messages can name it.
struct Date {
    std::string text;
};

/// A value of a deck with its place, independent of the file format.
struct Value {
    std::variant<bool, std::int64_t, double, std::string, Array, Table, Date> data;
    Location location;
};

/// A `key = value` of a table.
struct Entry {
    std::string key;
    Location key_location;
    Value value;
};

/// The entry with this key, or nullptr.
[[nodiscard]] const Entry* find(const Table& table, const std::string& key);
[[nodiscard]] Entry* find(Table& table, const std::string& key);

/// "a string", "an integer", ...: kind of a value for messages.
[[nodiscard]] std::string kind_name(const Value& value);

}  // namespace ljmd
