#include "cli/example_decks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/example_deck_texts.hpp"
#include "core/text.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

std::string_view ExampleDeck::title() const {
    const std::string_view line = line_of(text, 1);
    const std::size_t begin = line.find('"') + 1;
    return line.substr(begin, line.rfind('"') - begin);
}

std::span<const ExampleDeck> example_decks() {
    return example_deck_texts;
}

std::vector<std::string> example_names() {
    std::vector<std::string> names;
    for (const ExampleDeck& deck : example_decks()) {
        names.emplace_back(deck.name);
    }
    return names;
}

const ExampleDeck& example_deck(const std::string& name) {
    const std::span<const ExampleDeck> decks = example_decks();
    const auto found = std::ranges::find(decks, name, &ExampleDeck::name);
    if (found == decks.end()) {
        const std::string nearest = nearest_name(name, example_names());
        throw InputError(fmt::format("no example is named {}\n  {}", in_quotes(name),
                                     nearest.empty() ? "all names: ljmd init --list; a file of your own ends in .toml"
                                                     : fmt::format("did you mean '{}'?", nearest)));
    }
    return *found;
}

}  // namespace ljmd
