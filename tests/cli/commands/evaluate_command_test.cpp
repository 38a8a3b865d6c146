#include "catch.hpp"

#include "cli/command_words.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

using Words = std::vector<std::string>;

const std::string nist = LJMD_TEST_DATA "/nist/lj_sample_config_periodic4.txt";
const Words cut{"--truncation", "cut", "--cutoff", "3.0", "--tail", "false"};

void evaluate(const std::string& path, const Words& options = {}, const Words& more = {}) {
    Words words{"evaluate", path};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), more.begin(), more.end());
    command(words);
}

Data evaluated(const std::string& path, const Words& options = {}) {
    return parse_json(said([&] { evaluate(path, options, {"--json"}); }).out);
}

}  // namespace

TEST_CASE("evaluate takes the potential from options or from a deck, and from the two not at once") {
    const Data found = evaluated(nist, cut);
    CHECK(found["potential_energy"].number() * 30.0 == Approx(-16.79).epsilon(1e-4));
    CHECK(found["virial"].number() == Approx(-46.249).epsilon(1e-5));
    CHECK(found["forces"].size() == 30);
    const DeckFolder folder;
    const Deck deck = folder.load({});
    const Words by_deck{"--deck", deck.path, "--set", "potential.cutoff=3.0"};
    if (deck.potential().truncation == "cut") {
        CHECK(evaluated(nist, by_deck)["virial"] == found["virial"]);
    }
    CHECK_THROWS_WITH(evaluate(nist, by_deck, {"--cutoff", "3.0"}), Contains("--set"));
    CHECK_THROWS_WITH(evaluate(nist), Contains("--cutoff") && Contains("--truncation"));
    CHECK_THROWS_WITH(evaluate(nist, {"--truncation", "cut", "--cutoff", "3.0"}), Contains("--tail"));
    CHECK_THROWS_AS(evaluate(nist, cut, {"--frame", "3"}), DataError);
}

TEST_CASE("evaluate takes the directory of a run: its last configuration in its potential") {
    const DeckFolder folder;
    const Deck deck = folder.load({});
    run_until(deck, total_steps(deck.stages()));
    const Data found = evaluated(deck.directory.string());
    CHECK(found["step"].integer() == total_steps(deck.stages()));
    CHECK(found["pressure_parts"].text() == "kinetic and virial");
    CHECK(found["potential"]["cutoff"].number() == deck.potential().radius);
    CHECK_THROWS_WITH(evaluate(deck.directory.string(), {"--out", (deck.directory / "more.xyz").string()}),
                      Contains("directory of a run"));
}
