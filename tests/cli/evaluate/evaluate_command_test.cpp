#include "ljmd/cli/evaluate/evaluate_command.hpp"

#include <catch2/catch.hpp>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string nist = LJMD_TEST_DATA "/nist/lj_sample_config_periodic4.txt";

Data evaluated(EvaluateOptions options) {
    options.json = true;
    return parse_json(said([&] { evaluate_command(options); }).out);
}

}  // namespace

TEST_CASE("evaluate takes the potential from options or from a deck, and from the two not at once") {
    const EvaluateOptions cut{.path = nist, .truncation = "cut", .cutoff = 3.0, .tail = "false"};
    const Data found = evaluated(cut);
    CHECK(found["potential_energy"].number() * 30.0 == Approx(-16.79).epsilon(1e-4));
    CHECK(found["virial"].number() == Approx(-46.249).epsilon(1e-5));
    CHECK(found["forces"].size() == 30);
    const DeckFolder folder;
    const Deck deck = folder.load({});
    EvaluateOptions by_deck{.path = nist, .deck = deck.path, .settings = {"potential.cutoff=3.0"}};
    if (deck.potential().truncation == "cut") {
        CHECK(evaluated(by_deck)["virial"] == found["virial"]);
    }
    by_deck.cutoff = 3.0;
    CHECK_THROWS_WITH(evaluate_command(by_deck), Contains("--set"));
    CHECK_THROWS_WITH(evaluate_command({.path = nist}), Contains("--cutoff") && Contains("--truncation"));
    EvaluateOptions no_tail = cut;
    no_tail.tail = "";
    CHECK_THROWS_WITH(evaluate_command(no_tail), Contains("--tail"));
    EvaluateOptions third = cut;
    third.frame = 3;
    CHECK_THROWS_AS(evaluate_command(third), DataError);
}

TEST_CASE("evaluate takes the directory of a run: its last configuration in its potential") {
    const DeckFolder folder;
    const Deck deck = folder.load({});
    run_until(deck, total_steps(deck.stages));
    const Data found = evaluated({.path = deck.directory.string()});
    CHECK(found["step"].integer() == total_steps(deck.stages));
    CHECK(found["pressure_parts"].text() == "kinetic and virial");
    CHECK(found["potential"]["cutoff"].number() == deck.potential().radius);
    EvaluateOptions into_run{.path = deck.directory.string()};
    into_run.out = (deck.directory / "more.xyz").string();
    CHECK_THROWS_WITH(evaluate_command(into_run), Contains("directory of a run"));
}
