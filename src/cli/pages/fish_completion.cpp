#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ljmd/cli/pages/completion.hpp"

namespace ljmd {

namespace {

/// A text in single quotes.
std::string fish_quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) {
        out += c == '\'' || c == '\\' ? fmt::format("\\{}", c) : std::string(1, c);
    }
    return out + "'";
}

/// What fish calls for the values of an option or argument; empty if nothing is known of them.
std::string source_of(const std::string& value, const CommandTree& tree) {
    const PossibleValues values = possible_values(value, tree);
    if (!values.words.empty()) {
        return fmt::format("{}", fmt::join(values.words, " "));
    }
    return values.keys          ? "(__ljmd_keys)"
           : values.decks       ? "(__fish_complete_suffix .toml)"
           : values.files       ? "(__fish_complete_path)"
           : values.directories ? "(__fish_complete_directories)"
                                : "";
}

std::string fish_line(const CommandOption& option, const std::string& condition, const CommandTree& tree) {
    std::string text = fmt::format("complete -c ljmd {}", condition);
    for (const std::string& name : option.names) {
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    if (!option.value.empty()) {
        text += " -x";  // takes a value; files only where source_of() names them
        if (const std::string source = source_of(option.value, tree); !source.empty()) {
            text += fmt::format(" -a {}", fish_quoted(source));
        }
    }
    return text + fmt::format(" -d {}\n", fish_quoted(option.meaning));
}

std::string fish_lines(const Command& command, const CommandTree& tree) {
    const std::string condition = fmt::format("-n '__fish_seen_subcommand_from {}'", command.name);
    std::string text;
    for (const CommandOption& option : command.options) {
        if (!option.is_argument()) {
            text += fish_line(option, condition, tree);
        } else if (const std::string source = source_of(option.value, tree); !source.empty()) {
            text += fmt::format("complete -c ljmd {} -a {}\n", condition, fish_quoted(source));
        }
    }
    return text;
}

}  // namespace

std::string fish_completion(const CommandTree& tree) {
    std::string text = "# Completion of ljmd for fish, printed by `ljmd completion fish`.\n";
    text += fmt::format("function __ljmd_keys\n    printf '%s=\\n' {}\nend\n\n", fmt::join(all_deck_keys(), " "));
    text += "complete -c ljmd -f\n";
    for (const CommandOption& option : tree.program.named_options()) {
        text += fish_line(option, "-n __fish_use_subcommand", tree);
    }
    for (const Command& command : tree.commands) {
        text += fmt::format("complete -c ljmd -n __fish_use_subcommand -a {} -d {}\n", command.name,
                            fish_quoted(command.meaning));
    }
    for (const Command& command : tree.commands) {
        text += '\n' + fish_lines(command, tree);
    }
    return text;
}

}  // namespace ljmd
