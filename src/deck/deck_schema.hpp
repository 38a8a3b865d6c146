#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/options/schema.hpp"

namespace ljmd {

/// What a deck describes.
enum class DeckKind {
    fluid,     ///< atoms in a periodic box
    few_body,  ///< bodies without a box: `[force]` and `[[body]]`
};

/// The keys of a deck. Decks are validated with them, and the reference page is made from them. They are
/// described once in a process: a study loads thousands of decks.
[[nodiscard]] const Schema& deck_schema(DeckKind kind);

/// The tables by which a few-body deck is known: one with any of them is no fluid.
[[nodiscard]] std::vector<std::string> marks_of_few_bodies();

/// The reference page of all deck keys, in Markdown.
[[nodiscard]] std::string deck_reference_page();

/// A JSON Schema of decks of both kinds, see json_schema().
[[nodiscard]] std::string deck_json_schema();

}  // namespace ljmd
