#include "deck/sampled_steps.hpp"

#include "catch.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;

TEST_CASE("steps belong to the stages that are sampled, without their start") {
    const test::DeckFolder folder;
    const Deck deck = folder.load({});
    const SampledSteps steps(deck.stages());  // 20 steps, then 40 that are sampled
    CHECK_FALSE(steps.contain(0));
    CHECK_FALSE(steps.contain(20));
    CHECK(steps.stage_of(21) == std::size_t{1});
    CHECK(steps.stage_of(60) == std::size_t{1});
    CHECK_FALSE(steps.contain(61));
}

TEST_CASE("where no stage is sampled all are looked at") {
    const test::DeckFolder folder;
    const Deck deck = folder.load({"stage.production.sample=false"});
    const SampledSteps steps(deck.stages());
    CHECK_FALSE(steps.contain(0));
    CHECK(steps.stage_of(1) == std::size_t{0});
    CHECK(steps.stage_of(21) == std::size_t{1});
}

TEST_CASE("a run of no steps is sampled at its start") {
    const test::DeckFolder folder;
    const Deck deck = folder.load({"stage.equilibrate.steps=0", "stage.production.steps=0"});
    CHECK(SampledSteps(deck.stages()).contain(0));
    CHECK_FALSE(SampledSteps(deck.stages()).contain(1));
}

TEST_CASE("a time is before another one by more than rounding") {
    CHECK(is_before(0.99, 1.0));
    CHECK_FALSE(is_before(1.0 - 1e-12, 1.0));
    CHECK_FALSE(is_before(1.0, 1.0));
    CHECK(is_before(-0.1, 0.0));
}
