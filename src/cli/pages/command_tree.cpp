#include "ljmd/cli/pages/command_tree.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

#include "ljmd/cli/example_decks.hpp"
#include "ljmd/compare/crosscheck.hpp"
#include "ljmd/compare/export.hpp"
#include "ljmd/execution/simd.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/options/registry.hpp"
#include "ljmd/reference/equation_of_state.hpp"

namespace ljmd {

namespace {

std::vector<std::string> simd_names() {
    std::vector<std::string> names;
    for (const SimdLevel level : usable_simd_levels()) {
        names.emplace_back(name(level));
    }
    return names;
}

std::vector<std::string> analysis_names() {
    std::vector<std::string> names = plugin_names(all_analyses());
    names.emplace_back("thermo");
    return names;
}

std::vector<CommandOption> chosen(const std::vector<CommandOption>& options, bool arguments) {
    std::vector<CommandOption> found;
    std::ranges::copy_if(options, std::back_inserter(found),
                         [&](const CommandOption& option) { return option.is_argument() == arguments; });
    return found;
}

}  // namespace

std::vector<CommandOption> Command::arguments() const {
    return chosen(options, true);
}

std::vector<CommandOption> Command::named_options() const {
    return chosen(options, false);
}

std::vector<std::string> CommandTree::names() const {
    std::vector<std::string> names;
    std::ranges::transform(commands, std::back_inserter(names), &Command::name);
    return names;
}

PossibleValues possible_values(const std::string& value, const CommandTree& tree) {
    static const std::map<std::string, std::function<std::vector<std::string>()>> words{
        {"ANALYSIS", analysis_names},
        {"EQUATION", [] { return plugin_names(all_equations_of_state()); }},
        {"EXAMPLE", example_names},
        {"HOW",
         [] {
             return std::vector<std::string>{"wrapped", "unwrapped"};
         }},
        {"LEVEL", simd_names},
        {"P",
         [] {
             return std::vector<std::string>{"double", "mixed"};
         }},
        {"PART,...", [] { return crosscheck_parts(); }},
        {"PLATFORM",
         [] {
             return std::vector<std::string>{"Reference", "CPU", "OpenCL"};
         }},
        {"PROGRAM",
         [] {
             return std::vector<std::string>{"gsl", "lammps", "openmm"};
         }},
        {"SHELL",
         [] {
             return std::vector<std::string>{"bash", "fish", "zsh"};
         }},
        {"TABLE", [] { return std::vector<std::string>{"verlet1967"}; }},
        {"TARGET", [] { return export_targets(); }}};
    if (value == "COMMAND") {
        return {.words = tree.names()};
    }
    if (const auto found = words.find(value); found != words.end()) {
        return {.words = found->second()};
    }
    return {.keys = value == "KEY=VALUE" || value == "KEY=VALUES,...",
            .decks = value == "DECK",
            .files = value == "FILE" || value == "DECK|RUNDIR" || value == "RUNDIR|TRAJECTORY",
            .directories = value == "DIR" || value == "RUNDIR"};
}

}  // namespace ljmd
