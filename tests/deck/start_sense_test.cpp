#include "deck/start_sense.hpp"

#include "deck/deck_fixtures.hpp"
#include "integrators/thermostat.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "model/velocities.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string rescale_often = "thermostat = { type = \"rescale\", every = 5 }";
const std::string own = "temperature = 0.7\n" + rescale_often;

/// What is said of a deck that starts from a file, with or without velocities.
std::vector<Diagnostic> of_file(const Replacements& replacements, bool velocities = true,
                                std::vector<std::string> settings = {}) {
    const DeckFolder folder(
        changed(changed(small_deck, {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8\n", ""}}), replacements));
    const DeckFolder crystal;
    State state = simulation_of(crystal.load()).state;
    write_configuration(folder / "start.xyz", state, velocities);
    settings.push_back("system.file=" + (folder / "start.xyz").string());
    Diagnostics diagnostics;
    const auto deck = load_deck(folder.deck_path(), settings, false, diagnostics);
    REQUIRE(deck);
    CHECK(diagnostics.entries().empty());
    check_start(*deck, find_start(*deck), diagnostics);
    return diagnostics.entries();
}

void check_one(const std::vector<Diagnostic>& found, const std::string& line, const std::string& message,
               const std::string& hint) {
    REQUIRE(found.size() == 1);
    INFO(format(found[0]));
    CHECK(found[0].severity == Severity::warning);
    CHECK(line_shown(found[0]) == line);
    CHECK_THAT(found[0].message, Contains(message));
    CHECK_THAT(found[0].hint, Contains(hint));
}

const Replacements no_seed{{"seed = 7\n", ""}};

}  // namespace

TEST_CASE("a temperature beside velocities that are kept is told of, unless a thermostat holds it") {
    check_one(
        of_file({{"seed = 7\n", ""}, {rescale_often + "\n", ""}}), "temperature = 1.0",
        "'temperature' in [system] has no effect: the velocities are those of 'file', and no stage has a thermostat",
        "velocities = \"maxwell\"");
    check_one(of_file({{"seed = 7\n", ""}, {rescale_often, own}}), "temperature = 1.0",
              "every stage with a thermostat has a 'temperature' of its own (0.7)",
              "--set stage.equilibrate.temperature=1 sets a stage's");
    check_one(of_file({{"seed = 7\n", ""}, {"temperature = 1.0\n", ""}, {rescale_often, own}}, true,
                      {"system.temperature=3.0"}),
              "--set system.temperature=3.0", "has no effect", "stage.equilibrate.temperature=3");
    CHECK(of_file(no_seed).empty());
    CHECK(of_file({{"seed = 7\n", ""}, {"temperature = 1.0\n", ""}, {rescale_often, own}}).empty());
    // A thermostat that is at work in no step holds nothing.
    check_one(of_file(no_seed, true, {"stage.equilibrate.steps=0"}), "temperature = 1.0", "no stage has a thermostat",
              "");
    // Velocities that are drawn have it.
    CHECK(of_file({{rescale_often + "\n", ""}}, false).empty());
    CHECK(of_file({{rescale_often + "\n", ""}, {"seed = 7", "velocities = \"maxwell\""}}).empty());
}

TEST_CASE("a temperature that only the first velocities have is told of") {
    const auto of_lattice = [](const std::string& temperature, const std::vector<std::string>& settings = {}) {
        return complaints(
            changed(small_deck, {{"temperature = 1.0", "temperature = " + temperature}, {rescale_often, own}}),
            settings);
    };
    check_one(
        of_lattice("1.744"), "temperature = 1.744",
        "'temperature' in [system] is 1.744, which only the first velocities have: every stage with a thermostat has "
        "a 'temperature' of its own (0.7)",
        "--set stage.equilibrate.temperature=1.744");
    CHECK(of_lattice("0.7").empty());
    check_one(of_lattice("0.7", {"system.temperature=1.5"}), "--set system.temperature=1.5", "first velocities", "");
    CHECK(complaints(small_deck, {"system.temperature=1.5"}).empty());
}

TEST_CASE("a seed is told of where nothing is random") {
    const std::string message = "'seed' in [system] has no effect";
    const auto with = [](const std::string& thermostat) {
        return of_file({{rescale_often, "thermostat = { type = \"" + thermostat + "\" }"}});
    };
    for (const ThermostatMethod& method : all_thermostats()) {
        INFO(method.name);
        if (method.deterministic) {
            check_one(with(method.name), "seed = 7", message, "");
        } else {
            CHECK(with(method.name).empty());
        }
    }
    check_one(of_file({}, true, {"system.seed=1"}), "--set system.seed=1", message, "");
    CHECK(of_file(no_seed).empty());
    CHECK(of_file({}, false).empty());
    CHECK(of_file({}, true, {"analysis.chemical_potential={ every = 10 }"}).empty());
}

TEST_CASE("thermostats that are said to be deterministic do not depend on the seed, and the others do") {
    for (const ThermostatMethod& method : all_thermostats()) {
        INFO(method.name);
        const auto velocities = [&](std::uint64_t seed) {
            const DeckFolder folder(
                changed(small_deck, {{rescale_often, "thermostat = { type = \"" + method.name + "\" }"}}));
            const Deck deck = folder.load();
            FluidSystem simulation = simulation_of(deck);
            State& state = simulation.state;
            const auto thermostat = choose(method).options->make({1.3, 0.1, seed, degrees_of_freedom(state.count())});
            state.bath = thermostat->beginning();
            thermostat->before_step(state);
            thermostat->mid_drift(state);
            thermostat->after_step(state, 20);
            return Eigen::Matrix3Xd(state.velocities().matrix());
        };
        CHECK((velocities(1) == velocities(2)) == method.deterministic);
    }
}

TEST_CASE("the box of a file is checked, too") {
    const DeckFolder folder(changed(small_deck, {{"lattice = { type = \"fcc\", cells = 3 }", "file = \"start.xyz\""}}));
    const Deck deck = folder.load();
    Diagnostics diagnostics;
    check_start(deck, {100, Box(Vec3(6.0, 5.0, 3.75)), std::nullopt}, diagnostics);
    REQUIRE(diagnostics.entries().size() == 1);
    CHECK_THAT(diagnostics.entries()[0].message, Contains("more than half the box"));
}
