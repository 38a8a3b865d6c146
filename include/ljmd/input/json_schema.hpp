#pragma once

#include <string>
#include <vector>

#include "ljmd/core/schema.hpp"

namespace ljmd {

/// Two kinds of text: one that has a table of these names is described by `marked`, any other by `usual`.
struct SchemaChoice {
    std::vector<std::string> marks;
    Schema marked;
    Schema usual;
};

/// What schemas allow, as a JSON Schema (draft 7) for editors that complete and check: tables, keys with their
/// meanings, types, ranges, choices and defaults, and the keys that come with a choice. Units of quantities are
/// described in words, and what depends on several tables at once (an analysis that does not fit its stages) is not
/// said.
[[nodiscard]] std::string json_schema(const std::string& title, const SchemaChoice& choice);

}  // namespace ljmd
