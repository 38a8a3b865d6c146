#include "run/held_run.hpp"

#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a run is held to be resumed: its deck, its newest checkpoint, and as many threads as before") {
    const DeckFolder folder;
    const Deck deck = folder.load({"output.checkpoint.every=15"});
    run_until(deck, 40, 2);
    HeldRun run(deck.directory, 10, 0, no_warnings);
    CHECK(run.checkpoint().step == 30);
    CHECK(run.checkpoint().atoms == 108);
    CHECK(run.execution().threads() == 2);
    CHECK(total_steps(run.deck().stages()) == 70);
    CHECK(run.deck().locked.has_value());
    CHECK(run.warnings().empty());
    CHECK_FALSE(run.is_at_its_end());
    const Continuation from = run.take();
    CHECK(from.head.step == 30);
    CHECK(from.earlier.resumed_at_steps == std::vector<Index>{30});
    CHECK(from.earlier.steps_added == 10);
    CHECK_THROWS_AS(HeldRun(deck.directory, 0, 0, no_warnings), InUseError);
}

TEST_CASE("a run at its end says so, unless it is made longer") {
    const DeckFolder folder;
    const Deck deck = folder.load();
    run_until(deck, 60);
    CHECK(HeldRun(deck.directory, 0, 3, no_warnings).is_at_its_end());
    CHECK(HeldRun(deck.directory, 0, 3, no_warnings).execution().threads() == 3);
    CHECK_FALSE(HeldRun(deck.directory, 5, 0, no_warnings).is_at_its_end());
}

TEST_CASE("what is no run, or has no checkpoint, cannot be held") {
    const DeckFolder folder;
    CHECK_THROWS_AS(HeldRun(folder / "none", 0, 0, no_warnings), DataError);
    CHECK_THROWS_AS(HeldRun(folder.deck_path(), 0, 0, no_warnings), DataError);
    const Deck deck = folder.load();
    run_until(deck, 60);
    std::filesystem::remove(deck.directory / "checkpoint.1");
    std::filesystem::remove(deck.directory / "checkpoint.2");
    CHECK_THROWS_WITH(HeldRun(deck.directory, 0, 0, no_warnings), Contains("has no checkpoint: the run ended"));
}
