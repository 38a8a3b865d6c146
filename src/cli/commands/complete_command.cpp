#include "cli/command_line.hpp"
#include "cli/pages/completion.hpp"
#include "cli/streams.hpp"

namespace ljmd {

namespace {

/// Asked by the scripts of `ljmd completion`, at each press of a key.
class CompleteCommand : public Command {
  public:
    CompleteCommand() : Command("complete", Part::hidden, "what the last word can be") {}

    void add_options(CLI::App& command) override {
        program_ = command.get_parent();
        command.add_option("words", words_, "the words behind the name of the program")->type_name("WORD");
    }

    void run() override { print_result(completions(command_tree(*program_), words_)); }

  private:
    const CLI::App* program_ = nullptr;
    std::vector<std::string> words_;
};

}  // namespace

std::shared_ptr<Command> complete_command() {
    return std::make_shared<CompleteCommand>();
}

}  // namespace ljmd
