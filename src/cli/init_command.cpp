#include <fmt/format.h>

#include <filesystem>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/example_decks.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/text_table.hpp"
#include "ljmd/io/files/shell_word.hpp"
#include "ljmd/run/output_guard.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

std::string list_of_examples() {
    TextTable table({{"", TextTable::Align::left}, {"", TextTable::Align::left}});
    for (const ExampleDeck& deck : example_decks()) {
        table.add({std::string(deck.name), std::string(deck.title())});
    }
    return table.text();
}

}  // namespace

void init_command(const InitOptions& options) {
    if (options.list) {
        print_result(list_of_examples());
        return;
    }
    const ExampleDeck& deck = example_deck(options.example);
    const fs::path file = options.file.empty() ? fs::path(fmt::format("{}.toml", deck.name)) : fs::path(options.file);
    write_output(file, {.force = options.force}, deck.text);
    print_result(
        fmt::format("{0}\nto see what it costs: ljmd check {1}\nto run it: ljmd run {1}\nall keys: ljmd info --keys\n",
                    file.string(), shell_word(file)));
}

}  // namespace ljmd
