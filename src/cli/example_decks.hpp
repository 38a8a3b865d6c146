#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

/// A deck of inputs/, as it was when the program was built.
struct ExampleDeck {
    std::string_view name;  ///< of its file, without folder and ".toml"
    std::string_view text;

    [[nodiscard]] std::string_view title() const;  ///< from its first line
};

/// The decks of inputs/ that run alone, sorted by folder and name. Left out is what starts from the run of another
/// deck.
[[nodiscard]] std::span<const ExampleDeck> example_decks();

[[nodiscard]] std::vector<std::string> example_names();

/// The deck of this name. @throws InputError naming the nearest one if there is none
[[nodiscard]] const ExampleDeck& example_deck(const std::string& name);

}  // namespace ljmd
