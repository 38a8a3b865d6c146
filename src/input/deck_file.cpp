#include "input/deck_file.hpp"

#include <fstream>
#include <string_view>
#include <utility>

#include "input/toml_text.hpp"
#include "io/files/input_file.hpp"

namespace ljmd {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 20;
constexpr std::size_t default_beginning = 4096;

}  // namespace

DeckFile parse_deck(std::string name, std::string text, Diagnostics& diagnostics) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
    DeckFile deck;
    deck.source = std::make_shared<const Source>(Source{std::move(name), std::move(text)});
    if (deck.source->text.size() > max_bytes) {
        diagnostics.error({deck.source}, "larger than 1 MiB, which no deck is");
        return deck;
    }
    auto table = parse_toml(deck.source, diagnostics);
    if (table && table->empty()) diagnostics.error({deck.source}, "the deck is empty");
    if (table) deck.table = std::move(*table);
    return deck;
}

DeckFile read_deck(const std::filesystem::path& path, Diagnostics& diagnostics) {
    const auto fail = [&](const std::string& message) {
        DeckFile none{std::make_shared<const Source>(Source{path.string(), ""}), {}};
        diagnostics.error({none.source}, message);
        return none;
    };
    std::ifstream file;
    if (const std::string why = open_input(path, file); !why.empty()) return fail(why);
    // One byte more than allowed, after a byte order mark, shows that a text is too large, whatever its size.
    std::string text(max_bytes + 4, '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad()) return fail(why_reading_failed());
    text.resize(static_cast<std::size_t>(file.gcount()));
    if (const std::string why = why_no_text(std::string_view(text).substr(0, default_beginning)); !why.empty()) {
        return fail(why);
    }
    return parse_deck(path.string(), std::move(text), diagnostics);
}

}  // namespace ljmd
