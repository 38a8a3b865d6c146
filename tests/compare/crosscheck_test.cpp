#include "compare/crosscheck.hpp"

#include <algorithm>

#include "compare/openmm.hpp"
#include "compare/peers.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

/// The comparison of a deck with OpenMM, and what was said meanwhile.
struct Compared {
    Crosscheck found;
    std::vector<std::string> said;
};

Compared compared(const std::string& text, const CrosscheckOptions& options,
                  const std::vector<std::string>& settings = {}) {
    const DeckFolder folder(text);
    const Deck deck = folder.load(settings);
    FluidSystem simulation =
        make_fluid(fluid_spec(deck, find_start(deck)), Execution(execution_options(deck)), [](const std::string&) {});
    Recorder listener;
    std::vector<std::string> said;
    Crosscheck found =
        crosscheck(deck, simulation, options, listener, [&](const std::string& line) { said.push_back(line); });
    CHECK(static_cast<Index>(listener.steps.size()) == steps_before_crosscheck(deck));
    return {std::move(found), said};
}

}  // namespace

TEST_CASE("the stages before the first sampled one come before the comparison") {
    CHECK(steps_before_crosscheck(DeckFolder(small_deck).load()) == 20);
    const std::string more = "\n[[stage]]\nname = \"more\"\ntime_step = 0.004\nsteps = 7\nsample = true\n";
    CHECK(steps_before_crosscheck(DeckFolder(small_deck + more).load()) == 20);
    // None is sampled: all but the last.
    CHECK(steps_before_crosscheck(
              DeckFolder(small_deck + more).load({"stage.production.sample=false", "stage.more.sample=false"})) == 60);
    CHECK(steps_before_crosscheck(DeckFolder(small_deck).load({"stage.equilibrate.sample=true"})) == 0);
}

TEST_CASE("all parts are compared unless some are chosen") {
    CrosscheckOptions options;
    for (const std::string& part : crosscheck_parts()) {
        CHECK(options.wants(part));
    }
    options.parts = {"speed"};
    CHECK(options.wants("speed"));
    CHECK_FALSE(options.wants("point"));
}

TEST_CASE("a deck is compared with OpenMM in every part") {
    if (!openmm_is_here()) {
        return;
    }
    // In 400 steps both follow one trajectory: the means differ by less than a thousandth of their standard errors.
    const auto [found, said] =
        compared(small_deck, {.with = "openmm", .steps = 10, .frames = {1, 10, 100}}, {"stage.production.steps=400"});
    CHECK(found.atoms == 108);
    CHECK(found.steps_before == 20);
    CHECK(found.search == "verlet-list");
    CHECK(found.precision == "double");
    CHECK(found.steps_of_averages == 400);
    CHECK(found.peer == "OpenMM " + openmm_version() + " (Reference)");
    CHECK(found.fast_peer == "OpenMM " + openmm_version() + " (CPU, 1 thread)");
    CHECK(found.trajectory.rows.size() == 11);
    REQUIRE(found.ensemble);
    CHECK(found.ensemble->rows.size() == 3);
    CHECK(found.ensemble->frames > 0);
    REQUIRE(found.speed);
    CHECK(found.speed->ours > 0.0);
    CHECK(found.speed->theirs > 0.0);
    CHECK(said.size() == 3);
    // Point 4, trajectory 2 x 4, averages 4.
    CHECK(found.checks.size() == 16);
    for (const Check& check : found.checks) {
        INFO(check.name << ": " << check.value << ", allowed " << check.tolerance);
        CHECK(check.passed());
    }
    CHECK(found.passed());
    CHECK(found.failures() == 0);
}

TEST_CASE("parts that nobody wants are not compared") {
    if (!openmm_is_here()) {
        return;
    }
    const auto [found, said] = compared(small_deck, {.with = "openmm", .parts = {"point"}});
    CHECK(found.checks.size() == 4);
    CHECK(found.trajectory.rows.empty());
    CHECK_FALSE(found.ensemble);
    CHECK_FALSE(found.speed);
    CHECK(said.empty());
    CHECK(found.fast_peer == found.peer);
}

TEST_CASE("averages go by the deck's integrator where OpenMM has its like, else by velocity Verlet") {
    if (!openmm_is_here()) {
        return;
    }
    const CrosscheckOptions averages{.with = "openmm", .parts = {"averages"}};
    CHECK(compared(small_deck, averages, {"stage.production.integrator=leapfrog"}).found.integrator == "leapfrog");
    CHECK(compared(small_deck, averages, {"stage.production.integrator=forest-ruth"}).found.integrator ==
          "velocity-verlet");
}

TEST_CASE("a program that is not there is missed before anything is run") {
    if (!openmm_is_here()) {
        return;
    }
    const DeckFolder folder(small_deck);
    const Deck deck = folder.load();
    FluidSystem simulation =
        make_fluid(fluid_spec(deck, find_start(deck)), Execution(execution_options(deck)), [](const std::string&) {});
    Recorder listener;
    const CrosscheckOptions options{.with = "openmm", .platform = "Abacus"};
    CHECK_THROWS_AS(crosscheck(deck, simulation, options, listener, [](const std::string&) {}), InputError);
    CHECK(listener.steps.empty());
}
