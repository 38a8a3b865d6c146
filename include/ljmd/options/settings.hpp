#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ljmd/detail/options/schema.hpp"
#include "ljmd/detail/options/value.hpp"

namespace ljmd {

class Section;

/// Options by their keys: {{"time", 0.5}, {"length", 3}}.
using Settings = std::vector<std::pair<std::string, PlainValue>>;

/// "time=0.5 length=3": what tells options of one kind apart.
[[nodiscard]] std::string settings_in_words(const Settings& settings);

/// An entry that stands in no text.
template <class T>
[[nodiscard]] Entry entry_of(const std::string& key, T value) {
    return {key, {}, {std::move(value), {}}};
}

/// Append settings to a table.
void append(const Settings& settings, Table& table);

/// Check settings as a table of a deck is checked, but for its place.
/// @param title  of what has these keys, for messages
/// @throws InputError with all mistakes: keys that are unknown, missing or given twice, values of another type or
/// outside their range
[[nodiscard]] Section checked_settings(const std::string& title, const std::vector<Key>& keys,
                                       const Settings& settings);

}  // namespace ljmd
