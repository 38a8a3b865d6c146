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

struct DescribedCommand {
    std::string name;
    std::string meaning;
    std::vector<CommandOption> options;  ///< arguments in their order, and options

    [[nodiscard]] std::vector<CommandOption> arguments() const;
    [[nodiscard]] std::vector<CommandOption> named_options() const;
};

/// The program with its commands and options, as the parser of the command line knows them. Man page and completion are
/// made from it, so that they cannot forget an option.
struct CommandTree {
    DescribedCommand program;
    std::string version;
    std::vector<DescribedCommand> commands;

    [[nodiscard]] std::vector<std::string> names() const;  ///< of the commands
};

}  // namespace ljmd
