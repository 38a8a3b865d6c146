#include "cli/studies/reference_phase.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

// Its replicas are run by the tests in tests/cli/references.py: they are processes of the program.

TEST_CASE("a phase of a reference prepares its replicas, and is as long as it was before") {
    const DeckFolder folder;
    const std::filesystem::path out = folder / "out";
    std::filesystem::create_directory(out);
    {
        const ReferencePhase phase("pilot", out, small_deck, 40, 2, {});
        CHECK(phase.steps() == 40);
        CHECK(phase.folder().merged == out / "pilot");
        CHECK(phase.folder().runs.size() == 2);
        CHECK_THROWS_AS(ReferencePhase("pilot", out, small_deck, 40, 2, {}), InUseError);
    }
    auto plan = recorded_sweep(out / "pilot");
    REQUIRE(plan);
    plan->steps_added = 60;
    {
        const DirectoryLock lock(out / "pilot");
        record_sweep(*plan, lock.directory());
    }
    CHECK(ReferencePhase("pilot", out, small_deck, 40, 2, {}).steps() == 100);
    CHECK_THROWS_WITH(ReferencePhase("other", out, "", 40, 2, {}), Contains("the deck is empty"));
}
