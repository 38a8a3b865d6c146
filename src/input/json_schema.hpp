#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/options/schema.hpp"

namespace ljmd {

/// Two kinds of text: `marked` describes one that has a table with any of these names, `usual` any other.
struct SchemaChoice {
    std::vector<std::string> marks;
    Schema marked;
    Schema usual;
};

/// The schemas as a JSON Schema (draft 7), for editors that complete and check decks: tables, keys with their meanings,
/// types, ranges, choices and defaults, and the keys that belong to a choice. Units of quantities are described in
/// words. Conditions that involve several tables (an analysis that does not fit its stages) are not included.
[[nodiscard]] std::string json_schema(const std::string& title, const SchemaChoice& choice);

}  // namespace ljmd
