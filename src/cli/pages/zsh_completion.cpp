#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ljmd/cli/pages/completion.hpp"

namespace ljmd {

namespace {

/// The text with a backslash before each special character.
std::string escaped(const std::string& text, const std::string& special) {
    std::string out;
    for (const char c : text) {
        out += special.find(c) != std::string::npos ? fmt::format("\\{}", c) : std::string(1, c);
    }
    return out;
}

/// A text in single quotes.
std::string zsh_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return out + "'";
}

/// ":DIR:_files -/": message and action of _arguments.
std::string message_and_action(const std::string& value, const CommandTree& tree) {
    const PossibleValues values = possible_values(value, tree);
    std::string action = " ";  // nothing is known
    if (!values.words.empty()) {
        action = fmt::format("({})", fmt::join(values.words, " "));
    } else if (values.keys) {
        action = "_ljmd_keys";
    } else if (values.decks) {
        action = "_files -g \"*.toml(-.)\"";
    } else if (values.files) {
        action = "_files";
    } else if (values.directories) {
        action = "_files -/";
    }
    return fmt::format(":{}:{}", escaped(value, "\\:"), action);
}

/// The specifications of _arguments for an option, one a name.
std::string specifications(const CommandOption& option, const CommandTree& tree) {
    if (option.is_argument()) {
        return fmt::format(" \\\n                {}",
                           zsh_quoted((option.many ? "*" : "") + message_and_action(option.value, tree)));
    }
    std::string text;
    for (const std::string& name : option.names) {
        const std::string value = option.value.empty() ? "" : message_and_action(option.value, tree);
        text +=
            fmt::format(" \\\n                {}", zsh_quoted(fmt::format("{}{}[{}]{}", option.many ? "*" : "", name,
                                                                          escaped(option.meaning, "\\[]:"), value)));
    }
    return text;
}

std::string zsh_case(const Command& command, const CommandTree& tree) {
    std::string text = fmt::format("        {})\n            _arguments", command.name);
    for (const CommandOption& option : command.options) {
        text += specifications(option, tree);
    }
    return text + "\n            ;;\n";
}

}  // namespace

std::string zsh_completion(const CommandTree& tree) {
    std::string text = "#compdef ljmd\n# Completion of ljmd for zsh, printed by `ljmd completion zsh`.\n\n";
    text += fmt::format("_ljmd_keys() {{\n    local -a keys\n    keys=({})\n    compadd -S = -a keys\n}}\n\n",
                        fmt::join(all_deck_keys(), " "));
    text += "_ljmd_commands() {\n    local -a commands\n    commands=(\n";
    for (const Command& command : tree.commands) {
        text += fmt::format("        {}\n",
                            zsh_quoted(fmt::format("{}:{}", command.name, escaped(command.meaning, "\\:"))));
    }
    text += "    )\n    _describe command commands\n}\n\n_ljmd() {\n    local state line\n    _arguments -C";
    for (const CommandOption& option : tree.program.named_options()) {
        text += specifications(option, tree);
    }
    text +=
        " \\\n        ':command:_ljmd_commands' \\\n        '*:: :->rest'\n    [[ $state == rest ]] || return\n"
        "    case $line[1] in\n";
    for (const Command& command : tree.commands) {
        text += zsh_case(command, tree);
    }
    return text + "    esac\n}\n\n_ljmd \"$@\"\n";
}

}  // namespace ljmd
