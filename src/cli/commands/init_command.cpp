#include <fmt/format.h>

#include <filesystem>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/example_decks.hpp"
#include "cli/streams.hpp"
#include "core/text.hpp"
#include "core/text_table.hpp"
#include "io/files/shell_word.hpp"
#include "run/output_guard.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd init`.
struct InitOptions {
    std::string file{};     ///< deck to write, or the name of an example; empty: <example>.toml
    std::string example{};  ///< one of example_names(); empty: the one that `file` names, else the first
    bool force = false;
    bool list = false;  ///< print the examples instead
};

std::string list_of_examples() {
    TextTable table({{"", TextTable::Align::left}, {"", TextTable::Align::left}});
    for (const ExampleDeck& deck : example_decks()) {
        table.add({std::string(deck.name), std::string(deck.title())});
    }
    return table.text();
}

class InitCommand : public Command {
  public:
    InitCommand() : Command("init", Part::runs, "write a commented deck to begin with") {}

    void add_options(CLI::App& command) override {
        command.add_option("file", options_.file, "deck to write, EXAMPLE.toml by default; or EXAMPLE itself")
            ->type_name("FILE");
        command.add_option("--example", options_.example, "the deck of that name; first by default")
            ->type_name("EXAMPLE");
        command.add_flag("--force", options_.force, "replace the file if it exists");
        command.add_flag("--list", options_.list, "print names and titles of the examples; nothing is written");
    }

    void run() override {
        if (options_.list) {
            print_result(list_of_examples());
            return;
        }
        const bool names_example =
            options_.example.empty() && !options_.file.empty() && fs::path(options_.file).extension() != ".toml";
        const std::string asked = names_example ? options_.file : options_.example;
        const ExampleDeck& deck = example_deck(asked.empty() ? "first" : asked);
        const fs::path file =
            names_example || options_.file.empty() ? fmt::format("{}.toml", deck.name) : options_.file;
        write_output(file, {.force = options_.force}, deck.text);
        print_result(
            fmt::format("{0}: the example {2}\nto see what it costs: ljmd check {1}\nto run it: ljmd run {1}\nall "
                        "keys: ljmd info --keys\n",
                        file.string(), shell_word(file), in_quotes(deck.name)));
    }

  private:
    InitOptions options_;
};

}  // namespace

std::shared_ptr<Command> init_command() {
    return std::make_shared<InitCommand>();
}

}  // namespace ljmd
