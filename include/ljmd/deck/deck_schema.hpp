#pragma once

#include <string>

#include "ljmd/core/schema.hpp"

namespace ljmd {

/// Of a stage, or of a run that is gone on with.
inline constexpr Index most_steps = 1'000'000'000'000'000;

/// What a deck is a deck of.
enum class DeckKind {
    fluid,     ///< atoms in a periodic box
    few_body,  ///< bodies without a box: `[force]` and `[[body]]`
};

/// The keys of a deck: what validates it, and what the reference page is made from.
[[nodiscard]] Schema deck_schema(DeckKind kind);
[[nodiscard]] Schema few_body_schema();

/// What the stages and outputs of both kinds share.
[[nodiscard]] Schema stage_schema(DeckKind kind, const Key& time_step);
[[nodiscard]] Schema output_schema(const Schema& thermo, const Schema& trajectory, const std::string& thermo_default);

/// The reference page of all deck keys, in Markdown.
[[nodiscard]] std::string deck_reference_page();

/// A JSON Schema of decks of both kinds, see json_schema().
[[nodiscard]] std::string deck_json_schema();

}  // namespace ljmd
