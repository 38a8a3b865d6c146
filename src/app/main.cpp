#include <CLI/CLI.hpp>

#include "ljmd/app/commands.hpp"
#include "ljmd/core/build_info.hpp"

namespace {

void add_deck_options(CLI::App& command, ljmd::DeckOptions& options) {
    command.add_option("deck", options.deck, "deck (TOML); all keys: ljmd info --keys")->required()->type_name("DECK");
    command.add_option("--set", options.settings, "replace a value of the deck, e.g. --set system.density=0.8")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_flag("--force", options.force, "accept unlikely values; replace an earlier run");
    command.add_flag("--quiet", options.quiet, "no progress, no warnings about the deck");
    command.add_flag("--json", options.json, "print the result as JSON");
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Lennard-Jones molecular dynamics: Verlet's 1967 experiment and beyond", "ljmd");
    app.require_subcommand(1);
    app.set_version_flag("--version", "ljmd " + ljmd::build_info().version);

    ljmd::DeckOptions options;
    std::string out;
    bool keys = false;
    CLI::App& run = *app.add_subcommand("run", "run a deck and write its results");
    add_deck_options(run, options);
    run.add_option("--out", out, "output directory, instead of the deck's")->type_name("DIR");
    CLI::App& check = *app.add_subcommand("check", "find every mistake in a deck and tell what it would cost");
    add_deck_options(check, options);
    CLI::App& info = *app.add_subcommand("info", "version, build and what decks can select");
    info.add_flag("--keys", keys, "the reference page of all deck keys, in Markdown");

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int usage_error = 2;
        return app.exit(error) == 0 ? 0 : usage_error;
    }
    try {
        if (run.parsed()) {
            ljmd::run_command(options, out);
        } else if (check.parsed()) {
            ljmd::check_command(options);
        } else {
            ljmd::info_command(keys);
        }
    } catch (...) {
        return ljmd::report_current_exception();
    }
    return 0;
}
