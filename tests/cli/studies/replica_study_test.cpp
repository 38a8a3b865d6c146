#include "cli/studies/replica_study.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "study/replicas.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Replicas are run by the tests in tests/cli/until.py: they are processes of the program.

TEST_CASE("the deck of replicas is the one that was recorded, with its settings") {
    const DeckFolder folder(small_deck);
    SweepPlan plan = replica_plan(folder.load(), {"system.temperature=1.5"}, 3);
    CHECK(deck_of_replicas(plan).system().temperature == 1.5);
    plan.settings = {"system.temperature=-1"};
    CHECK_THROWS_WITH(deck_of_replicas(plan), Contains("temperature"));
}
