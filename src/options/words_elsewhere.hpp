#pragma once

#include <string>

namespace ljmd {

/// What stands in a deck for a word that other programs and texts use: "csvr", "nvt", "g(r)", or that ljmd has no such
/// thing. Letters' case, hyphens, underscores, blanks and slashes do not matter.
/// @return a hint, as after the underline of a message; empty for a word that is not known
[[nodiscard]] std::string word_elsewhere(const std::string& word);

}  // namespace ljmd
