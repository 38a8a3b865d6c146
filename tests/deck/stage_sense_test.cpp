#include "deck/stage_sense.hpp"
#include "integrators/thermostat.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const std::string name_of_fluid = "name = \"production\"";
const std::string name_of_bodies = "name = \"orbits\"";

/// The one thing that is said of a deck of either kind whose stage is called so, and the line it is said of.
void check_refused(const std::string& name, const std::string& message) {
    const std::string line = "name = \"" + name + "\"";
    for (const std::string& text :
         {changed(small_deck, {{name_of_fluid, line}}), changed(stars_deck, {{name_of_bodies, line}})}) {
        INFO(text);
        const auto found = complaints(text);
        REQUIRE(found.size() == 1);
        CHECK(found[0].severity == Severity::error);
        CHECK(line_shown(found[0]) == line);
        CHECK_THAT(found[0].message, Contains(message));
    }
}

std::string another_stage(const std::string& name, const std::string& steps) {
    return "\n[[stage]]\nname = \"" + name + "\"\ntime_step = 0.004\nsteps = " + steps + "\n";
}

}  // namespace

TEST_CASE("a stage's name is one that can be spoken of, in both kinds of deck") {
    check_refused("", "1 to 64 printable");
    check_refused("a\\u001b[2J", "1 to 64 printable");
    check_refused(std::string(65, 'x'), "1 to 64 printable");
    const std::string longest = "name = \"" + std::string(64, 'x') + "\"";
    CHECK(complaints(changed(small_deck, {{name_of_fluid, longest}})).empty());
    CHECK(complaints(changed(stars_deck, {{name_of_bodies, longest}})).empty());
}

TEST_CASE("two stages of one name are refused at the second, in both kinds of deck") {
    for (const auto& [text, name] : {std::pair{small_deck, "equilibrate"}, std::pair{stars_deck, "orbits"}}) {
        const auto found = complaints(text + another_stage(name, "1"));
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0].message, Contains(std::string("two stages are called '") + name + "'"));
        CHECK(found[0].location.line > 15);
        CHECK(complaints(text + another_stage("another", "1")).empty());
    }
}

TEST_CASE("steps that a counter cannot hold are refused") {
    std::string many;
    for (int k = 0; k < 4700; ++k) {
        many += another_stage(std::to_string(k), "1000000000000000");
    }
    for (const std::string& text : {small_deck, stars_deck}) {
        const auto found = complaints(text + many);
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0].message, Contains("more than 2^62"));
    }
}

namespace {

/// The small deck with other lines in place of the thermostat of its first stage.
std::string bathed(const std::string& lines) {
    return changed(small_deck, {{"thermostat = { type = \"rescale\", every = 5 }", lines}});
}

constexpr const char* rescaling = "thermostat = { type = \"stochastic-rescaling\" }\n";
constexpr const char* half_pressure = "barostat = { type = \"stochastic-cell-rescaling\", pressure = 0.5 }\n";

}  // namespace

TEST_CASE("thermostats that act in every step are parts of velocity-verlet, rescaling goes with all integrators") {
    for (const auto& method : all_thermostats()) {
        CAPTURE(method.name);
        const std::string thermostat = "thermostat = { type = \"" + method.name + "\" }\n";
        CHECK(complaints(bathed(thermostat)).empty());
        const auto found = complaints(bathed("integrator = \"leapfrog\"\n" + thermostat));
        REQUIRE(found.size() == (method.every_step ? 1 : 0));
        if (method.every_step) {
            CHECK_THAT(found[0].message, Contains("part of the steps of velocity-verlet") && Contains("is leapfrog"));
        }
    }
}

TEST_CASE("a thermostat needs a temperature, a canonical one above 0") {
    const auto cold = complaints(bathed(std::string("temperature = 0.0\n") + rescaling));
    REQUIRE(cold.size() == 1);
    CHECK_THAT(cold[0].message, Contains("needs a temperature above 0"));
    CHECK(
        complaints(bathed("temperature = 0.0\nthermostat = { type = \"rescale\" }"), {"system.temperature=0"}).empty());

    const std::string from_file =
        changed(bathed(rescaling),
                {{"lattice = { type = \"fcc\", cells = 3 }", "file = \"a.xyz\""}, {"temperature = 1.0\n", ""}});
    const auto none = complaints(from_file);
    REQUIRE(none.size() == 1);
    CHECK_THAT(none[0].message, Contains("missing key 'temperature' in [[stage]]"));
    CHECK(complaints(changed(from_file, {{"thermostat =", "temperature = 0.7\nthermostat ="}})).empty());
}

TEST_CASE("a barostat needs a canonical thermostat beside it") {
    CHECK(complaints(bathed(std::string(rescaling) + half_pressure)).empty());
    for (const std::string& lines :
         {std::string(half_pressure), std::string("thermostat = { type = \"rescale\" }\n") + half_pressure}) {
        const auto found = complaints(bathed(lines));
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0].message, Contains("needs a canonical thermostat"));
        CHECK_THAT(line_shown(found[0]), Contains("barostat ="));
    }
}

TEST_CASE("what is sampled under a thermostat that samples no ensemble is warned of, under a canonical one not") {
    CHECK(complaints(bathed(std::string("sample = true\n") + rescaling)).empty());
    const auto found = complaints(bathed("sample = true\nthermostat = { type = \"rescale\" }"));
    REQUIRE(found.size() == 1);
    CHECK(found[0].severity == Severity::warning);
    CHECK_THAT(found[0].message, Contains("samples no ensemble"));
}

TEST_CASE("a stage begins at a total energy only at constant energy, where no temperature is held") {
    const auto with = [](const std::string& lines) {
        return complaints(changed(small_deck, {{"sample = true\n", "sample = true\ntotal_energy = -3.0\n" + lines}}));
    };
    CHECK(with("").empty());
    const auto warm = with("temperature = 1.0\n");
    REQUIRE(warm.size() == 1);
    CHECK(warm[0].severity == Severity::error);
    CHECK_THAT(warm[0].message, Contains("'total_energy' and 'temperature' in one [[stage]]"));
    CHECK_THAT(line_shown(warm[0]), Contains("total_energy"));
    const auto held = with("thermostat = { type = \"andersen\" }\n");
    REQUIRE(held.size() == 1);
    CHECK_THAT(held[0].message, Contains("a thermostat would change it"));
    CHECK_THAT(complaints(changed(stars_deck, {{"steps = 95\n", "steps = 95\ntotal_energy = -3.0\n"}})).at(0).message,
               Contains("total_energy"));
}
