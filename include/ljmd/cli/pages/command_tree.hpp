#pragma once

#include <string>
#include <vector>

namespace ljmd {

/// An option of a command, or an argument without a name.
struct CommandOption {
    std::vector<std::string> names;  ///< "--help", "-h"; none for an argument
    std::string value;               ///< what it takes, "DIR"; empty for a flag
    std::string meaning;
    bool required = false;
    bool many = false;  ///< takes several values, or may be repeated

    [[nodiscard]] bool is_argument() const { return names.empty(); }
};

struct Command {
    std::string name;
    std::string meaning;
    std::vector<CommandOption> options;  ///< arguments in their order, and options

    [[nodiscard]] std::vector<CommandOption> arguments() const;
    [[nodiscard]] std::vector<CommandOption> named_options() const;
};

/// The program with its commands and options, as the parser of the command line knows them. Man page and completion are
/// made from it, so that they cannot forget an option.
struct CommandTree {
    Command program;
    std::string version;
    std::vector<Command> commands;

    [[nodiscard]] std::vector<std::string> names() const;  ///< of the commands
};

/// What a value of an option can be, for completion.
struct PossibleValues {
    std::vector<std::string> words{};
    bool keys = false;         ///< of a deck, with '=' behind
    bool decks = false;        ///< files whose names end in .toml, and directories
    bool files = false;        ///< any file or directory
    bool directories = false;  ///< directories alone
};

/// The possible values of an option, by the word that its help has for them ("DIR", "LEVEL"). All empty where nothing
/// is known of them, as of numbers and times.
/// @param tree  names the commands, which are the values of "COMMAND"
[[nodiscard]] PossibleValues possible_values(const std::string& value, const CommandTree& tree);

}  // namespace ljmd
