#include "cli/bench.hpp"
#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"

namespace ljmd {

namespace {

class BenchCommand : public Command {
  public:
    BenchCommand()
        : Command("bench", Part::program,
                  "measure how fast a deck runs; without one, the Lennard-Jones melt of 32000 atoms") {}

    void add_options(CLI::App& command) override { options_.add_to(command, false); }

    void run() override {
        Diagnostics diagnostics;
        Deck deck = options_.deck.empty() ? melt(diagnostics) : options_.load(diagnostics);
        require_fluid(deck, "a few-body deck has no speed worth measuring: `ljmd bench` wants a fluid");
        CheckedRun fluid = options_.checked(deck, diagnostics);
        const BenchResult result = bench(std::move(deck), std::move(fluid.start.value()), fluid.execution);
        print_result(options_.json ? bench_json(result) : bench_report(result));
    }

  private:
    /// The deck for those who name none.
    [[nodiscard]] Deck melt(Diagnostics& diagnostics) const {
        auto deck = load_deck_text("melt-32k.toml", std::string(melt_deck()), options_.all_settings(), options_.force,
                                   diagnostics);
        diagnostics.throw_if_errors();
        return std::move(*deck);
    }

    DeckOptions options_;
};

}  // namespace

std::shared_ptr<Command> bench_command() {
    return std::make_shared<BenchCommand>();
}

}  // namespace ljmd
