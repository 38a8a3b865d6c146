#include "ljmd/engine/few_body_simulation.hpp"

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/choices.hpp"
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

TEST_CASE("a program runs few bodies without a deck: a planet on a circle comes back") {
    const double year = 8.0 * std::atan(1.0);
    FewBodySpec spec{
        .force = few_body_force("newtonian-gravity", {{"gravitational_constant", 1.0}, {"central_mass", 1.0}}),
        .bodies = {{.mass = 1e-9, .position = {1.0, 0.0}, .velocity = {0.0, 1.0}}}};
    spec.stages = {{.name = "year", .time_step = year / 2000.0, .steps = 2000, .sample = true}};
    spec.sample_every = 100;
    FewBodySimulation planet(spec);
    CHECK_THROWS_AS(planet.result(), InputError);
    CHECK_THROWS_AS(planet.advance(-1), InputError);
    const FewBodyResult result = planet.run();
    CHECK(planet.finished());
    CHECK(planet.state().positions()(0, 0) == Approx(1.0).margin(1e-4));
    CHECK(planet.state().positions()(1, 0) == Approx(0.0).margin(1e-4));
    CHECK(planet.samples().size() == 21);
    CHECK(result.bodies == 1);
    CHECK(result.dimensions == 2);
}

TEST_CASE("who asks for frames of few bodies gets those that are due, and every row") {
    struct Frames : ljmd::RunOutputs {
        using RunOutputs::row;
        void row(const FewBodyRow& row) override { rows.push_back(row.step); }
        [[nodiscard]] bool frame_is_due(const State& state) const override { return state.step % 4 == 0; }
        void frame(const State& state, const std::optional<double>& /*angle*/) override { steps.push_back(state.step); }
        std::vector<Index> rows;
        std::vector<Index> steps;
    };
    FewBodySpec spec = two_bodies();
    Frames frames;
    FewBodySimulation simulation(spec, {}, &frames);
    simulation.advance(25);
    CHECK(frames.steps == std::vector<Index>{0, 4, 8, 12, 16, 20, 24});
    CHECK(frames.rows == std::vector<Index>{0, 10, 20});
    CHECK(simulation.samples().size() == 3);
}

TEST_CASE("few bodies come to the end, also where the last stages have no steps") {
    FewBodySpec spec = two_bodies();
    spec.stages.push_back({.name = "nothing", .time_step = 0.005, .steps = 0});
    FewBodySimulation simulation(spec);
    simulation.run();
    CHECK(simulation.finished());
    CHECK(simulation.result().stages.size() == 3);
}

TEST_CASE("few bodies that were moved or have failed say so") {
    FewBodySimulation first(two_bodies());
    FewBodySimulation second = std::move(first);
    CHECK_THROWS_AS(first.advance(1), InputError);  // NOLINT(bugprone-use-after-move)
    CHECK_THROWS_AS(first.state(), InputError);
    CHECK_THROWS_AS(first.finished(), InputError);
    second.advance(1);
    first = std::move(second);
    CHECK(first.state().step == 1);

    FewBodySpec unstable{.force = few_body_force("harmonic", {{"stiffness", 1.0}}),
                         .bodies = {{.mass = 1.0, .position = {1.0}, .velocity = {0.0}}}};
    unstable.stages = {{.name = "far too long steps", .time_step = 1000.0, .steps = 1000}};
    FewBodySimulation failing(unstable);
    REQUIRE_THROWS_AS(failing.run(), PhysicsError);
    CHECK(failing.state().count() == 1);
    CHECK_NOTHROW(failing.state().velocities());  // no kick is pending
    CHECK_THROWS_AS(failing.advance(1), InputError);
}
