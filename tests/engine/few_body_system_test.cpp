#include "engine/few_body_system.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// The springs of a deck with bodies in one, two or three dimensions.
Deck springs_in(const std::string& position, const std::string& velocity) {
    return DeckFolder("[force]\ntype = \"harmonic\"\nstiffness = 3.0\n\n[[body]]\nmass = 2.0\nposition = " + position +
                      "\nvelocity = " + velocity + "\n\n[[stage]]\nname = \"swing\"\ntime_step = 0.1\nsteps = 1\n")
        .load();
}

}  // namespace

TEST_CASE("bodies start as the deck says, in its order, without a box") {
    const Deck deck = DeckFolder(changed(stars_deck, {{"mass = 0.5", "mass = 0.25"}})).load();
    const State state = make_few_body_system(deck.few_bodies()).state;
    CHECK(state.count() == 2);
    CHECK_FALSE(state.has_box());
    CHECK(state.ids() == std::vector<Index>{0, 1});
    CHECK(state.masses() == std::vector<double>{0.25, 0.5});
    CHECK(Vec3(state.positions().col(0)) == Vec3(-0.5, 0.0, 0.0));
    CHECK(Vec3(state.velocities().col(0)) == Vec3(0.0, -0.3, 0.0));
    CHECK(Vec3(state.positions().col(1)) == Vec3(0.5, 0.0, 0.0));
    CHECK(Vec3(state.velocities().col(1)) == Vec3(0.0, 0.3, 0.0));
}

TEST_CASE("components that a deck leaves out are zero") {
    const State line = make_few_body_system(springs_in("[1.5]", "[-2.0]").few_bodies()).state;
    CHECK(Vec3(line.positions().col(0)) == Vec3(1.5, 0.0, 0.0));
    CHECK(Vec3(line.velocities().col(0)) == Vec3(-2.0, 0.0, 0.0));
    const State space = make_few_body_system(springs_in("[1.5, 2.5, 3.5]", "[1, 2, 3]").few_bodies()).state;
    CHECK(Vec3(space.positions().col(0)) == Vec3(1.5, 2.5, 3.5));
    CHECK(Vec3(space.velocities().col(0)) == Vec3(1.0, 2.0, 3.0));
}

TEST_CASE("what stands for the mass of a pendulum is its moment of inertia") {
    const Deck deck = DeckFolder(
                          "[force]\ntype = \"pendulum\"\ngravity = 9.81\nlength = 2.0\n\n[[body]]\nmass = 3.0\n"
                          "position = [1.0]\nvelocity = [0.5]\n\n[[stage]]\nname = \"swing\"\n"
                          "time_step = 0.1\nsteps = 1\n")
                          .load();
    const FewBodySpec& spec = deck.few_bodies();
    CHECK(few_body_start(spec.bodies, *chosen_few_body_force(spec.force).options).masses() ==
          std::vector<double>{12.0});
}

TEST_CASE("a few-body system has the dimensions and the force of its deck") {
    const Deck deck = springs_in("[1.5, 2.5]", "[0, 0]");
    FewBodySystem system = make_few_body_system(deck.few_bodies());
    CHECK(system.dimensions == 2);
    CHECK(system.force.plugin.name == "harmonic");
    CHECK(system.analyses.empty());
    const Evaluation evaluation = system.force_field->evaluate(system.state, Request::forces_and_energy);
    CHECK(evaluation.potential_energy == 0.5 * 3.0 * (1.5 * 1.5 + 2.5 * 2.5));
    CHECK(make_few_body_system(springs_in("[1.5]", "[0]").few_bodies()).dimensions == 1);
    CHECK(make_few_body_system(springs_in("[1.5, 0, 0]", "[0, 0, 0]").few_bodies()).dimensions == 3);
}

TEST_CASE("a few-body system has the analyses that its deck asks for, by name") {
    const Deck deck =
        DeckFolder(stars_deck + "\n[analysis]\norbit = { body = 1, about = 2 }\nclosest_approach = {}\n").load();
    const FewBodySystem system = make_few_body_system(deck.few_bodies());
    REQUIRE(system.analyses.size() == 2);
    CHECK(system.analyses[0].first == "closest_approach");
    CHECK(system.analyses[1].first == "orbit");
}
