#include "cli/command.hpp"
#include "cli/pages/completion.hpp"
#include "cli/streams.hpp"

namespace ljmd {

namespace {

class CompletionCommand : public Command {
  public:
    CompletionCommand()
        : Command("completion", Part::program, "script with which a shell completes commands, options and keys") {}

    void add_options(CLI::App& command) override {
        command.add_option("shell", shell_, "bash, fish or zsh")
            ->required()
            ->type_name("SHELL")
            ->check(CLI::IsMember(completed_shells()));
    }

    void run() override { print_result(std::string(completion_script(shell_))); }

  private:
    std::string shell_;
};

}  // namespace

std::shared_ptr<Command> completion_command() {
    return std::make_shared<CompletionCommand>();
}

}  // namespace ljmd
