#include "catch.hpp"

#include "io/tables/json_text.hpp"
#include "judge/judge.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

Judgement made_judgement() {
    return {.engine = "mine",
            .atoms = 108,
            .steps_before = 20,
            .path = "verlet-list",
            .checks = {{"virial", 1.0, 1e-12}, {"potential energy", 0.0, 1e-12}},
            .means = {{"temperature", {1.5, 0.1, 50.0, 100, true}, {1.7, 0.0, 50.0, 100, true}, 0.1}},
            .diagnoses = {"virial: the sign is wrong"},
            .not_judged = {"trajectory: there are no frames"},
            .warnings = {"a remark"}};
}

}  // namespace

TEST_CASE("the table of a judgement says what failed, why, and what was not judged") {
    const DeckFolder folder(small_deck);
    const Deck deck = folder.load();
    Judgement found = made_judgement();
    const std::string text = judgement_table(found, deck);
    CHECK_THAT(text, Contains("against mine\n108 atoms, after 20 steps of the deck\nljmd: verlet-list\n"));
    CHECK_THAT(text, Contains("diagnosis:\n  virial: the sign is wrong\n"));
    CHECK_THAT(text, Contains("not judged:\n  trajectory: there are no frames\n"));
    CHECK_THAT(text, Contains("1 of 2 checks FAILED\n") && Contains("2.00"));
    found.diagnoses.clear();
    CHECK_THAT(judgement_table(found, deck), Contains("1 of 2 checks FAILED; no mistake that is known explains it\n"));
    found.checks.erase(found.checks.begin());
    CHECK_THAT(judgement_table(found, deck), Contains("all 1 checks passed\n"));
    found.own_failure = "it blew up";
    CHECK_THAT(judgement_table(found, deck),
               Contains("all 1 checks passed; no verdict: ljmd's own run of the deck failed\n"));
    CHECK(parse_json(judgement_json(found, deck, "files:x"))["passed"].is_null());
    found.checks.clear();
    CHECK_THAT(judgement_table(found, deck), Contains("nothing was judged\n"));
}

TEST_CASE("a judgement as JSON has all of it") {
    const DeckFolder folder(small_deck);
    const Data json = parse_json(judgement_json(made_judgement(), folder.load(), "files:x"));
    CHECK(json["with"].text() == "files:x");
    CHECK_FALSE(json["passed"].flag());
    CHECK(json["checks"].size() == 2);
    CHECK(json["averages"]["observables"]["temperature"]["sigmas"].number() == Approx(2.0));
    CHECK(json["diagnoses"].size() == 1);
    CHECK(json["not_judged"].size() == 1);
    CHECK(json["warnings"].size() == 1);
}
