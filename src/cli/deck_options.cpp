#include "cli/deck_options.hpp"

#include "cli/streams.hpp"
#include "execution/threads.hpp"
#include "input/reduced_number.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/execution/simd.hpp"

namespace ljmd {

void DeckOptions::add_to(CLI::App& command, bool deck_is_required) {
    command.add_option("deck", deck, "deck (TOML); all keys: ljmd info --keys")
        ->required(deck_is_required)
        ->type_name("DECK");
    command.add_option("--set", settings, "replace a value of the deck, e.g. --set system.density=0.8")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_flag("--force", force, "accept unlikely values; replace an earlier run");
    command.add_flag("--quiet", quiet, "no progress, no warnings about the deck");
    command.add_flag("--json", json, "print the result as JSON");
    add_threads(command, threads);
    command.add_option("--precision", precision, "double or mixed, instead of the deck's")->type_name("P");
    add_simd(command, simd);
}

std::vector<std::string> DeckOptions::all_settings() const {
    // Report a wrong --simd or LJMD_SIMD before anything is done.
    static_cast<void>(default_simd_level(simd));
    std::vector<std::string> all = settings;
    if (!precision.empty()) {
        all.push_back("performance.precision=" + precision);
    }
    return all;
}

Deck DeckOptions::load(Diagnostics& diagnostics) const {
    const std::vector<std::string> all = all_settings();
    if (deck.empty()) {
        throw InputError("the name of the deck is empty");
    }
    auto found = load_deck(deck, all, force, diagnostics);
    diagnostics.throw_if_errors();
    return std::move(*found);
}

CheckedRun DeckOptions::checked(const Deck& of, Diagnostics& diagnostics, const std::shared_ptr<Ranks>& ranks) const {
    CheckedRun run = checked_run(of, threads, simd, diagnostics, ranks);
    if (!quiet) {
        print_warnings(diagnostics);
    }
    return run;
}

CLI::Option* add_threads(CLI::App& command, int& threads, const std::string& meaning) {
    return command.add_option("--threads", threads, meaning)->type_name("N")->check(CLI::Range(1, max_threads));
}

CLI::Option* add_simd(CLI::App& command, std::string& simd) {
    return command.add_option("--simd", simd, "instruction set of the kernels, one that `ljmd info` lists")
        ->type_name("LEVEL");
}

CLI::Option* add_jobs(CLI::App& command, int& jobs, const std::string& meaning) {
    return command.add_option("--jobs", jobs, meaning)->type_name("N")->check(CLI::Range(1, max_threads));
}

CLI::Option* add_walltime(CLI::App& command, std::string& walltime, const std::string& of) {
    return command
        .add_option("--walltime", walltime, of + "stop after that long with a checkpoint: 90s, 30min, 2h, 1d")
        ->type_name("TIME");
}

CLI::Validator reduced(const std::string& unit, Dimension dimension) {
    return {[=](const std::string& text) { return not_reduced(text, unit, dimension); }, ""};
}

}  // namespace ljmd
