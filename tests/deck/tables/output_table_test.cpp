#include "deck/tables/output_table.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

std::string absent_text(const Schema& schema, const std::string& key) {
    return schema.find(key)->absent_text;
}

}  // namespace

TEST_CASE("outputs of a fluid that the deck does not name have their defaults") {
    const Deck deck = DeckFolder(small_deck).load();
    const FluidOutputTable& output = deck.fluid().output;
    CHECK(output.thermo.every == FluidSpec().sample_every);
    CHECK_FALSE(output.trajectory.has_value());
    CHECK(output.checkpoint.every.seconds == 300.0);
    CHECK_FALSE(output.checkpoint.every.steps.has_value());
    CHECK(output.checkpoint.keep == 2);
    const Deck written = DeckFolder(small_deck).load({"output.trajectory.every=7", "output.checkpoint.every=40"});
    REQUIRE(written.trajectory.has_value());
    CHECK(written.trajectory->format == "h5md");
    CHECK_FALSE(written.trajectory->si());
    CHECK(written.checkpoint.every.steps == 40);
    CHECK_FALSE(written.checkpoint.every.seconds.has_value());
}

TEST_CASE("the page tells of the defaults that the members have") {
    const Schema fluid = Placed<FluidOutputTable>::schema("[output]");
    CHECK(absent_text(fluid, "thermo") == "every 10 steps");
    CHECK(absent_text(fluid, "checkpoint") == "every 5 minutes");
    CHECK(fluid.find("checkpoint")->inner.front().find("every")->default_value == PlainValue(std::string("5 min")));
    const Schema few_body = Placed<FewBodyOutputTable>::schema("[output]");
    CHECK(absent_text(few_body, "thermo") == "every step");
    CHECK(few_body.find("trajectory")->inner.front().find("format")->default_value == PlainValue(std::string("csv")));
}
