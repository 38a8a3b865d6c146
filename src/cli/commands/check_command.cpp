#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"

namespace ljmd {

namespace {

class CheckCommand : public Command {
  public:
    CheckCommand() : Command("check", Part::runs, "find every mistake in a deck, and estimate its cost") {}

    void add_options(CLI::App& command) override { options_.add_to(command); }

    void run() override {
        Diagnostics diagnostics;
        const Deck deck = options_.load(diagnostics);
        print_document(check_report(deck, options_.checked(deck, diagnostics)), options_.json);
    }

  private:
    DeckOptions options_;
};

}  // namespace

std::shared_ptr<Command> check_command() {
    return std::make_shared<CheckCommand>();
}

}  // namespace ljmd
