#include "cli/pages/completion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "cli/example_decks.hpp"
#include "compare/crosscheck.hpp"
#include "compare/export.hpp"
#include "core/text.hpp"
#include "deck/deck_schema.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/execution/simd.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "options/key_paths.hpp"

namespace ljmd {

namespace {

using Words = std::vector<std::string>;

Words simd_names() {
    Words names;
    for (const SimdLevel level : usable_simd_levels()) {
        names.emplace_back(name(level));
    }
    return names;
}

Words analysis_names() {
    Words names = plugin_names(all_analyses());
    names.emplace_back("thermo");
    return names;
}

/// Dotted keys of all decks as --set takes them, sorted, with the equals sign; "NAME" and "NUMBER" stand for an element
/// of an array of tables.
Words deck_keys() {
    std::set<std::string> keys;
    for (const DeckKind kind : {DeckKind::fluid, DeckKind::few_body}) {
        for (const KeyPlace& place : key_places(deck_schema(kind))) {
            if (!place.is_table) {
                keys.insert(place.path + "=");
            }
        }
    }
    return {keys.begin(), keys.end()};
}

/// The possible values of an option, by the word that its help has for them. None where nothing is known of them, as of
/// numbers and times.
Words possible_values(const std::string& value, const CommandTree& tree) {
    const auto always = [](const Words& words) { return [=] { return words; }; };
    static const std::map<std::string, std::function<Words()>> known{
        {"ANALYSIS", analysis_names},
        {"DECK", always({":decks"})},
        {"DECK|DIR", always({":decks"})},
        {"DECK|RUNDIR", always({":files"})},
        {"DIR", always({":directories"})},
        {"DIR|FILE", always({":files"})},
        {"CONFIGURATION", always({":files"})},
        {"EQUATION", [] { return plugin_names(all_equations_of_state()); }},
        {"EXAMPLE", example_names},
        {"FILE", always({":files"})},
        {"HOW", always({"wrapped", "unwrapped"})},
        {"KEY=VALUE", deck_keys},
        {"KEY=VALUES,...", deck_keys},
        {"LEVEL", simd_names},
        {"P", always({"double", "mixed"})},
        {"PART,...", crosscheck_parts},
        {"PLATFORM", always({"Reference", "CPU", "OpenCL"})},
        {"PROGRAM", always({"gsl", "lammps", "openmm"})},
        {"RUN", always({":directories"})},
        {"RUNDIR", always({":directories"})},
        {"RUNDIR|TRAJECTORY", always({":files"})},
        {"SHELL", completed_shells},
        {"TABLE|DIR", always({"verlet1967", ":directories"})},
        {"TARGET", export_targets}};
    if (value == "COMMAND") {
        return tree.names();
    }
    const auto found = known.find(value);
    return found == known.end() ? Words{} : found->second();
}

/// The option that a word names; none: no option of the command.
std::optional<CommandOption> named_by(const DescribedCommand& command, const std::string& word) {
    for (const CommandOption& option : command.named_options()) {
        if (std::ranges::find(option.names, word) != option.names.end()) {
            return option;
        }
    }
    return std::nullopt;
}

/// The argument that comes behind these words; none: all are there.
std::optional<CommandOption> next_argument(const DescribedCommand& command, const Words& before) {
    const std::vector<CommandOption> arguments = command.arguments();
    std::size_t given = 0;
    for (std::size_t k = 0; k < before.size(); ++k) {
        if (!before[k].starts_with('-')) {
            ++given;
        } else if (const auto option = named_by(command, before[k]); option && !option->value.empty()) {
            ++k;  // its value
        }
    }
    if (given < arguments.size()) {
        return arguments[given];
    }
    return arguments.empty() || !arguments.back().many ? std::nullopt : std::optional(arguments.back());
}

struct Meaning {
    std::string word;
    std::string meaning{};
};

std::vector<Meaning> options_of(const DescribedCommand& command) {
    std::vector<Meaning> found;
    for (const CommandOption& option : command.named_options()) {
        for (const std::string& name : option.names) {
            found.push_back({name, option.meaning});
        }
    }
    return found;
}

std::vector<Meaning> values_of(const std::optional<CommandOption>& option, const CommandTree& tree,
                               const std::string& in_front = "") {
    std::vector<Meaning> found;
    for (const std::string& word : option ? possible_values(option->value, tree) : Words{}) {
        found.push_back({word.starts_with(':') ? word : in_front + word});
    }
    return found;
}

/// What the word behind the others of a command can be.
std::vector<Meaning> words_of(const DescribedCommand& command, const Words& before, const std::string& word,
                              const CommandTree& tree) {
    if (const std::size_t equals = word.find('='); word.starts_with("--") && equals != std::string::npos) {
        return values_of(named_by(command, word.substr(0, equals)), tree, word.substr(0, equals + 1));
    }
    if (!before.empty()) {
        if (const auto option = named_by(command, before.back()); option && !option->value.empty()) {
            return values_of(option, tree);
        }
    }
    return word.starts_with('-') ? options_of(command) : values_of(next_argument(command, before), tree);
}

constexpr std::string_view bash_script = R"bash(# Completion of ljmd for bash, printed by `ljmd completion bash`.
_ljmd() {
    # The line up to the cursor: readline splits its words at '=' and ':', too, and replaces what is behind these.
    local line=${COMP_LINE:0:COMP_POINT} words found
    read -ra words <<<"$line"
    [[ $line == *[[:space:]] ]] && words+=("")
    local word=${words[-1]} behind
    behind=$word
    [[ $word == *=* ]] && behind=${word#*=}
    COMPREPLY=()
    while IFS=$'\t' read -r found _; do
        case $found in
            :decks)
                compopt -o filenames
                mapfile -t COMPREPLY < <(compgen -f -X '!*.toml' -- "$behind"; compgen -d -- "$behind") ;;
            :files)
                compopt -o filenames
                mapfile -t COMPREPLY < <(compgen -f -- "$behind") ;;
            :directories)
                compopt -o filenames
                mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$behind") ;;
            *)
                [[ $found == *= ]] && compopt -o nospace
                COMPREPLY+=("${found#"${word%"$behind"}"}") ;;
        esac
    done < <(command ljmd complete -- "${words[@]:1}" 2>/dev/null)
}
complete -F _ljmd ljmd
)bash";

constexpr std::string_view fish_script = R"fish(# Completion of ljmd for fish, printed by `ljmd completion fish`.
function __ljmd_words
    set -l words (commandline -opc) (commandline -ct)
    command -q ljmd; or return
    for line in (command ljmd complete -- $words[2..] 2>/dev/null)
        switch $line
            case ':decks*'
                __fish_complete_suffix .toml
            case ':files*'
                __fish_complete_path (commandline -ct)
            case ':directories*'
                __fish_complete_directories (commandline -ct)
            case '*'
                echo $line
        end
    end
end
complete -c ljmd -f -a '(__ljmd_words)'
)fish";

constexpr std::string_view zsh_script = R"zsh(#compdef ljmd
# Completion of ljmd for zsh, printed by `ljmd completion zsh`.

_ljmd() {
    local word meaning files
    local -a whole open
    while IFS=$'\t' read -r word meaning; do
        case $word in
            :*) files=$word ;;
            *=) open+=("${word//:/\\:}:$meaning") ;;
            *) whole+=("${word//:/\\:}:$meaning") ;;
        esac
    done < <(command ljmd complete -- "${(@Q)words[2,CURRENT-1]}" "${(Q)PREFIX}" 2>/dev/null)
    (($#whole)) && _describe -t words word whole
    (($#open)) && _describe -t keys key open -S ''
    compset -P '--*='
    case $files in
        :decks) _files -g "*.toml(-.)" ;;
        :files) _files ;;
        :directories) _files -/ ;;
    esac
}

_ljmd "$@"
)zsh";

const std::map<std::string, std::string_view>& scripts() {
    static const std::map<std::string, std::string_view> all{
        {"bash", bash_script}, {"fish", fish_script}, {"zsh", zsh_script}};
    return all;
}

}  // namespace

std::string completions(const CommandTree& tree, const std::vector<std::string>& words) {
    const std::string word = words.empty() ? "" : words.back();
    Words before = words;
    before.resize(words.empty() ? 0 : words.size() - 1);
    std::vector<Meaning> found;
    const auto name = std::ranges::find_if(before, [](const std::string& one) { return !one.starts_with('-'); });
    if (name == before.end()) {
        found = options_of(tree.program);
        for (const DescribedCommand& command : tree.commands) {
            found.push_back({command.name, command.meaning});
        }
    } else if (const auto command = std::ranges::find(tree.commands, *name, &DescribedCommand::name);
               command != tree.commands.end()) {
        found = words_of(*command, {std::next(name), before.end()}, word, tree);
    }
    std::string text;
    for (const auto& [possible, meaning] : found) {
        if (possible.starts_with(':') || possible.starts_with(word)) {
            text += fmt::format("{}\t{}\n", possible, meaning);
        }
    }
    return text;
}

std::vector<std::string> completed_shells() {
    Words names;
    for (const auto& [shell, script] : scripts()) {
        names.push_back(shell);
    }
    return names;
}

std::string_view completion_script(const std::string& shell) {
    const auto found = scripts().find(shell);
    if (found == scripts().end()) {
        throw InputError(fmt::format("no completion for {}; there is one for bash, fish and zsh", in_quotes(shell)));
    }
    return found->second;
}

}  // namespace ljmd
