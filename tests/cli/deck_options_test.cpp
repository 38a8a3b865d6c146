#include "cli/deck_options.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a deck is read with the settings of all options") {
    const DeckFolder folder;
    DeckOptions options{.deck = folder.deck_path().string(), .settings = {"system.seed=5"}, .precision = "mixed"};
    Diagnostics diagnostics;
    const Deck deck = options.load(diagnostics);
    CHECK(deck.system().seed == 5);
    CHECK(options.all_settings() == std::vector<std::string>{"system.seed=5", "performance.precision=mixed"});
    options.simd = "mmx";
    CHECK_THROWS_AS(options.load(diagnostics), InputError);
    CHECK_THROWS_WITH(DeckOptions{}.load(diagnostics), "the name of the deck is empty");
}

TEST_CASE("numbers of options are in reduced units") {
    CLI::App app("test");
    double temperature = 0.0;
    app.add_option("--temperature", temperature)->check(reduced("epsilon/k_B", Dimension::temperature));
    CHECK_THROWS_AS(app.parse(std::vector<std::string>{"120 K", "--temperature"}), CLI::ValidationError);
    app.parse(std::vector<std::string>{"1.5", "--temperature"});
    CHECK(temperature == 1.5);
}
