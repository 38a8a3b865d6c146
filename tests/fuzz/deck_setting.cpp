#include "deck/sample_decks.hpp"
#include "deck_promises.hpp"

using namespace ljmd;

// Each line is the argument of a --set.
LJMD_FUZZ_TARGET(deck_setting) {
    std::vector<std::string> settings;
    std::string_view rest = fuzz::text_of(data, size);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        settings.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    Diagnostics diagnostics;
    const auto deck = load_deck_text("deck.toml", test::small_deck, settings, false, diagnostics);
    fuzz::check_promises(deck, diagnostics);
    return 0;
}
