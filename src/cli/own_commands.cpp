#include "ljmd/cli/own_commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ljmd/cli/described_commands.hpp"
#include "ljmd/cli/pages/completion.hpp"
#include "ljmd/cli/pages/man_page.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

CommandTree tree_of(const CLI::App& app) {
    return command_tree(app, build_info().version);
}

}  // namespace

OwnCommands::OwnCommands(CLI::App& app)
    : app_(app),
      init_(*app.add_subcommand("init", "write a commented deck to begin with")),
      help_(*app.add_subcommand("help", "what a command does, and its options")),
      version_(*app.add_subcommand("version", "version of the program")),
      completion_(*app.add_subcommand("completion", "script with which a shell completes commands, options and keys")) {
    CLI::App& init = *app.get_subcommand("init");
    init.add_option("file", begun_.file, "deck to write, EXAMPLE.toml by default")->type_name("FILE");
    init.add_option("--example", begun_.example, "the deck of that name; first by default")->type_name("EXAMPLE");
    init.add_flag("--force", begun_.force, "replace the file if it exists");
    init.add_flag("--list", begun_.list, "print names and titles of the examples; nothing is written");
    CLI::App& help = *app.get_subcommand("help");
    CLI::Option* one = help.add_option("command", command_, "without one, all are listed")->type_name("COMMAND");
    help.add_flag("--man", man_, "print the manual page, for `man -l -`")->excludes(one);
    app.get_subcommand("completion")
        ->add_option("shell", shell_, "bash, fish or zsh")
        ->required()
        ->type_name("SHELL")
        ->check(CLI::IsMember({"bash", "fish", "zsh"}));
}

bool OwnCommands::parsed() const {
    return init_.parsed() || help_.parsed() || version_.parsed() || completion_.parsed();
}

int OwnCommands::run() const {
    if (help_.parsed()) {
        return help();
    }
    if (init_.parsed()) {
        init_command(begun_);
    } else if (version_.parsed()) {
        print_result(fmt::format("ljmd {}\n", build_info().version));
    } else {
        print_result(completion(tree_of(app_), shell_));
    }
    return 0;
}

int OwnCommands::help() const {
    if (man_) {
        print_result(man_page(tree_of(app_)));
        return 0;
    }
    if (command_.empty()) {
        // App::help() would be that of the command that was parsed.
        print_result(app_.get_formatter()->make_help(&app_, app_.get_name(), CLI::AppFormatMode::Normal));
        return 0;
    }
    const std::vector<const CLI::App*> commands = commands_of(app_);
    const auto found =
        std::ranges::find(commands, command_, [](const CLI::App* command) { return command->get_name(); });
    if (found == commands.end()) {
        throw InputError(unknown_command(app_, command_));
    }
    print_result((*found)->help(app_.get_name()));
    return 0;
}

}  // namespace ljmd
