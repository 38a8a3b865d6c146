#include "fuzz_target.hpp"
#include "ljmd/app/deck.hpp"

using namespace ljmd;

namespace {

const std::string text = R"(
[system]
lattice = { type = "fcc", cells = 3 }
density = 0.8
temperature = 1.0
[potential]
type = "lennard-jones"
cutoff = 2.0
[[stage]]
name = "production"
time_step = 0.004
steps = 40
)";

}  // namespace

// Each line is the argument of a --set.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> settings;
    std::string_view rest = fuzz::text_of(data, size);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        settings.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    Diagnostics diagnostics;
    const auto deck = load_deck_text("deck.toml", text, settings, false, diagnostics);
    fuzz::require(deck.has_value() == !diagnostics.has_errors(), "a deck is there in spite of errors, or not without");
    for (const Diagnostic& entry : diagnostics.entries()) {
        fuzz::require(!format(entry).empty(), "a mistake without a word");
    }
    return 0;
}
