#pragma once

#include <string>

#include "ljmd/core/schema.hpp"

namespace ljmd {

/// Maximum number of steps of a stage, and of a resumed run.
inline constexpr Index max_steps = 1'000'000'000'000'000;

/// The `type` of a lattice that is none: atoms at random places.
inline constexpr const char* random_lattice = "random";

/// What a deck describes.
enum class DeckKind {
    fluid,     ///< atoms in a periodic box
    few_body,  ///< bodies without a box: `[force]` and `[[body]]`
};

/// The keys of a deck. Decks are validated with them, and the reference page is made from them.
[[nodiscard]] Schema deck_schema(DeckKind kind);
[[nodiscard]] Schema few_body_schema();

/// Common to the stages and outputs of both kinds.
[[nodiscard]] Schema stage_schema(DeckKind kind, const Key& time_step);
[[nodiscard]] Schema output_schema(const Schema& thermo, const Schema& trajectory, const std::string& thermo_default);

/// The reference page of all deck keys, in Markdown.
[[nodiscard]] std::string deck_reference_page();

/// A JSON Schema of decks of both kinds, see json_schema().
[[nodiscard]] std::string deck_json_schema();

}  // namespace ljmd
