#include "engine/few_body_simulation.hpp"

#include "deck/deck_fixtures.hpp"
#include "model/checksum.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// Two bodies of equal mass on ellipses, there and back.
FewBodySpec two_bodies() {
    FewBodySpec spec = DeckFolder(stars_deck).load().few_bodies();
    spec.stages = {{.name = "there", .time_step = 0.005, .steps = 95, .sample = true},
                   {.name = "back", .time_step = 0.005, .steps = 40, .reverse = true}};
    spec.sample_every = 10;
    return spec;
}

}  // namespace

TEST_CASE("few bodies in memory take the steps of one time loop, however they are asked for") {
    FewBodySimulation whole(two_bodies());
    whole.advance(1000);
    FewBodySimulation pieces(two_bodies());
    for (const Index steps : {0, 1, 30, 64, 0, 7, 33}) {
        CHECK_FALSE(pieces.finished());
        pieces.advance(steps);
    }
    CHECK(whole.finished());
    CHECK(pieces.finished());
    CHECK(whole.state().step == 135);
    CHECK(checksum(pieces.state()) == checksum(whole.state()));
    REQUIRE(pieces.samples().size() == whole.samples().size());
    for (std::size_t k = 0; k < pieces.samples().size(); ++k) {
        CHECK(pieces.samples()[k].step == whole.samples()[k].step);
        CHECK(pieces.samples()[k].values.total_energy == whole.samples()[k].values.total_energy);
    }
}

TEST_CASE("few bodies in memory end with a sample of the end, once") {
    FewBodySimulation simulation(two_bodies());
    simulation.advance(1000);
    CHECK(simulation.samples().front().step == 0);
    CHECK(simulation.samples().back().step == 135);
    const std::size_t count = simulation.samples().size();
    CHECK(count == 15);  // 0, 10, ..., 130, and 135
    simulation.advance(1);
    CHECK(simulation.samples().size() == count);
    const FewBodyResult result = simulation.result();
    REQUIRE(result.stages.size() == 2);
    CHECK(result.stages[1].reversed);
    CHECK(result.bodies == 2);
}
