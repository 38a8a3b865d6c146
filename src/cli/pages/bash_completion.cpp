#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "ljmd/cli/pages/completion.hpp"

namespace ljmd {

namespace {

/// The part of the script that is the same for every program. `kind` says what the word can be: "words", "keys",
/// "decks", "files", "directories" or "nothing".
constexpr const char* frame = R"bash(
# The word before the cursor, whole: readline splits it at '=' and ':'.
_ljmd() {{
    local IFS=$' \t\n'
    local line=${{COMP_LINE:0:COMP_POINT}}
    local word=${{line##*[[:space:]]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command= kind=words words= argument
    if [[ $word == --*=* ]]; then  # --out=DIR
        before=${{word%%=*}} word=${{word#*=}}
    elif [[ $word == *[=:]* ]]; then
        kind=nothing
    fi
    for argument in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        if [[ -n $argument && $argument != -* ]]; then
            command=$argument
            break
        fi
    done
    if [[ -z $command ]]; then
        words="{0} {1}"
    elif [[ $kind == words ]]; then
        _ljmd_of_command
    fi
    COMPREPLY=()
    case $kind in
        words) mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word") ;;
        keys)
            compopt -o nospace
            mapfile -t COMPREPLY < <(compgen -S = -W "$_ljmd_keys" -- "$word")
            ;;
        decks)
            compopt -o filenames
            mapfile -t COMPREPLY < <(compgen -f -X '!*.toml' -- "$word"; compgen -d -- "$word")
            ;;
        files)
            compopt -o filenames
            mapfile -t COMPREPLY < <(compgen -f -- "$word")
            ;;
        directories)
            compopt -o filenames
            mapfile -t COMPREPLY < <(compgen -d -- "$word")
            ;;
    esac
}}
complete -F _ljmd ljmd
)bash";

/// Assignments that say what a value can be.
std::string assignments(const CommandOption& option, const CommandTree& tree) {
    const PossibleValues values = possible_values(option.value, tree);
    if (!values.words.empty()) {
        return fmt::format("words=\"{}\"", fmt::join(values.words, " "));
    }
    return fmt::format("kind={}", values.keys          ? "keys"
                                  : values.decks       ? "decks"
                                  : values.files       ? "files"
                                  : values.directories ? "directories"
                                                       : "nothing");
}

/// What follows the options of a command: its argument, the same for all where it takes several. The first argument
/// decides; of `ljmd analyze PATH ANALYSIS ...` the second is another.
std::string arguments_of(const Command& command, const CommandTree& tree) {
    const std::vector<CommandOption> arguments = command.arguments();
    if (arguments.empty()) {
        return "kind=nothing";
    }
    std::string text = assignments(arguments.front(), tree);
    if (arguments.size() > 1) {
        text =
            fmt::format("if [[ $COMP_CWORD -gt 2 ]]; then {}; else {}; fi", assignments(arguments.back(), tree), text);
    }
    return text;
}

std::string bash_case(const Command& command, const CommandTree& tree) {
    std::string text = fmt::format("        {})\n            case $before in\n", command.name);
    std::vector<std::string> all;
    for (const CommandOption& option : command.named_options()) {
        all.insert(all.end(), option.names.begin(), option.names.end());
        if (!option.value.empty()) {
            text +=
                fmt::format("                {}) {} ;;\n", fmt::join(option.names, " | "), assignments(option, tree));
        }
    }
    text += fmt::format(
        "                *) if [[ $word == -* ]]; then words=\"{}\"; else {}; fi ;;\n            esac\n            "
        ";;\n",
        fmt::join(all, " "), arguments_of(command, tree));
    return text;
}

}  // namespace

std::string bash_completion(const CommandTree& tree) {
    std::vector<std::string> options;
    for (const CommandOption& option : tree.program.named_options()) {
        options.insert(options.end(), option.names.begin(), option.names.end());
    }
    std::string text = "# Completion of ljmd for bash, printed by `ljmd completion bash`.\n";
    text += fmt::format("_ljmd_keys=\"{}\"\n\n", fmt::join(all_deck_keys(), " "));
    text +=
        "# Sets kind and words for the word that is completed, from the variables of _ljmd.\n_ljmd_of_command() {\n"
        "    case $command in\n";
    for (const Command& command : tree.commands) {
        text += bash_case(command, tree);
    }
    text += "        *) kind=nothing ;;\n    esac\n}\n";
    return text + fmt::format(fmt::runtime(frame), fmt::join(tree.names(), " "), fmt::join(options, " "));
}

}  // namespace ljmd
