#include <algorithm>

#include "cli/command_line.hpp"
#include "cli/pages/man_page.hpp"
#include "cli/streams.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

class HelpCommand : public Command {
  public:
    HelpCommand() : Command("help", Part::program, "what a command does, and its options") {}

    void add_options(CLI::App& command) override {
        program_ = command.get_parent();
        CLI::Option* one = command.add_option("command", command_, "without one, all are listed")->type_name("COMMAND");
        command.add_flag("--man", man_, "print the manual page, for `man -l -`")->excludes(one);
    }

    void run() override {
        if (man_) {
            print_result(man_page(command_tree(*program_)));
            return;
        }
        if (command_.empty()) {
            // App::help() would give the help of the command that was parsed.
            print_result(
                program_->get_formatter()->make_help(program_, program_->get_name(), CLI::AppFormatMode::Normal));
            return;
        }
        const std::vector<const CLI::App*> commands = program_->get_subcommands([](const CLI::App*) { return true; });
        const auto found = std::ranges::find(commands, command_, [](const CLI::App* one) { return one->get_name(); });
        if (found == commands.end()) {
            throw InputError(unknown_command(*program_, command_));
        }
        print_result((*found)->help(program_->get_name()));
    }

  private:
    const CLI::App* program_ = nullptr;
    std::string command_;  ///< empty: all
    bool man_ = false;
};

}  // namespace

std::shared_ptr<Command> help_command() {
    return std::make_shared<HelpCommand>();
}

}  // namespace ljmd
