#include "deck/analysis_sense.hpp"

#include <algorithm>
#include "catch.hpp"

#include "deck/deck_fixtures.hpp"
#include "deck/errors_in.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

constexpr const char* stages = R"(
[[stage]]
name = "first"
time_step = 0.002
steps = 30
sample = true
temperature = 0.9
thermostat = { type = "rescale" , every = 5 }

[[stage]]
name = "second"
time_step = 0.002
steps = 200
sample = true

[[stage]]
name = "last"
time_step = 0.001
steps = 500
)";

SampledRun run_of(const std::string& deck) {
    return sampled_run(DeckFolder(deck).load(), 10, Box(Vec3::Constant(5.0)));
}

}  // namespace

TEST_CASE("analyses hear of the sampled stages only: the first one's time step, the longest one's steps") {
    const SampledRun run = run_of(changed(small_deck, {{"sample = true\n", ""}}) + stages);
    CHECK(run.atoms == 10);
    CHECK(run.box.edges() == Vec3::Constant(5.0));
    CHECK(run.time_step == 0.002);
    CHECK(run.steps == 200);
    CHECK(run.held_temperature == std::optional<double>(0.9));
    CHECK_FALSE(run.interaction.has_value());
}

TEST_CASE("a run at constant energy holds no temperature") {
    const SampledRun run = run_of(small_deck);
    CHECK(run.time_step == 0.004);
    CHECK(run.steps == 40);
    CHECK_FALSE(run.held_temperature.has_value());
}

TEST_CASE("a film has no analysis that is for a homogeneous fluid") {
    const std::string deck = changed(small_deck, {{"cells = 3", "cells = 3, height = 20"}}) + "[analysis]\n";
    CHECK(errors_in(complaints(deck + "chemical_potential = {}\nfilm = {}\n")) == 0);
    const auto found = complaints(deck + "cutoff_correction = {}\n");
    REQUIRE(errors_in(found) == 1);
    CHECK_THAT(found.front().message, Contains("the analysis cutoff_correction is for a homogeneous fluid"));
    CHECK(errors_in(complaints(small_deck + "[analysis]\nfilm = {}\ncutoff_correction = {}\n")) == 0);
}

TEST_CASE("where configurations at different times are compared, sampled stages have one time step") {
    const auto mistakes = [](const std::string& analysis) {
        const auto found = complaints(small_deck + stages + "[analysis]\n" + analysis + " = {}\n");  // 0.004 and 0.002
        return std::ranges::count_if(found, [](const Diagnostic& diagnostic) {
            return diagnostic.message.find("time steps of 0.004 and 0.002") != std::string::npos;
        });
    };
    CHECK(mistakes("rdf") == 0);
    CHECK(mistakes("structure_factor") == 0);
    for (const char* analysis : {"msd", "vacf", "viscosity"}) {
        CHECK(mistakes(analysis) == 2);  // at each of the two stages that differ from the first one
    }
}

TEST_CASE("times that are longer than the run are found when the deck is checked") {
    for (const std::string name : {"msd", "vacf", "viscosity"}) {
        CAPTURE(name);
        const auto found = complaints(small_deck + "[analysis]\n" + name + " = { max_time = 0.5 }\n");
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0].message, Contains("'max_time' in " + name) && Contains("no more than 0.16 tau"));
    }
}

TEST_CASE("analyses need a box that stays as it is from the first sampled stage on") {
    const std::string bath =
        "thermostat = { type = \"stochastic-rescaling\" }\n"
        "barostat = { type = \"stochastic-cell-rescaling\", pressure = 0.5 }\n";
    const std::string before = changed(small_deck, {{"thermostat = { type = \"rescale\", every = 5 }\n", bath}});
    const std::string after = small_deck + "\n[[stage]]\nname = \"later\"\ntime_step = 0.004\nsteps = 5\n" + bath;
    for (const std::string& text : {before, after}) {
        CHECK(errors_in(complaints(text)) == 0);
    }
    CHECK(errors_in(complaints(before + "\n[analysis]\nrdf = {}\n")) == 0);
    const auto found = complaints(after + "\n[analysis]\nmsd = {}\n");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Contains("'msd' needs a box that stays as it is"));
    CHECK_THAT(found[0].hint,
               Contains("with a barostat are: configurational_temperature, crystal, rdf, response_functions"));
    CHECK_THAT(line_shown(found[0]), Contains("barostat ="));
    // These are of the box of each configuration.
    CHECK(errors_in(complaints(after + "\n[analysis]\nresponse_functions = {}\nconfigurational_temperature = {}\n")) ==
          0);
    CHECK(errors_in(complaints(after + "\n[analysis]\nresponse_functions = {}\nrdf = {}\n")) == 0);
}

TEST_CASE("a potential with a step is refused where its impulses would count, and continuous ones are named") {
    for (const std::string name : {"thermal_conductivity", "bulk_viscosity"}) {
        CAPTURE(name);
        const std::string text = small_deck + "[analysis]\n" + name + " = {}\n";
        CHECK(complaints(text).empty());
        const auto found = complaints(changed(text, {{"\"force-shifted\"", "\"cut\"\ntail = true"}}));
        REQUIRE(found.size() == 1);
        CHECK_THAT(found[0].message, Contains("the analysis " + name + " needs a continuous potential") &&
                                         Contains("continuous are shifted, force-shifted and switched"));
        CHECK_THAT(line_shown(found[0]), Contains("truncation = \"cut\""));
    }
    CHECK(complaints(
              changed(small_deck + "[analysis]\nviscosity = {}\n", {{"\"force-shifted\"", "\"cut\"\ntail = true"}}))
              .empty());
}

TEST_CASE("bulk viscosity is refused where sampled stages have a thermostat, thermal conductivity is not") {
    const std::string text =
        changed(small_deck, {{"sample = true\n", "sample = true\nthermostat = { type = \"stochastic-rescaling\" }\n"}});
    CHECK(complaints(text + "[analysis]\nthermal_conductivity = {}\n").empty());
    const auto found = complaints(text + "[analysis]\nbulk_viscosity = {}\n");
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0].message, Contains("bulk_viscosity needs sampled stages at constant energy"));
    CHECK_THAT(line_shown(found[0]), Contains("stochastic-rescaling"));
}

TEST_CASE("a thermostat that changes how atoms move is warned of where motion is measured") {
    for (const std::string type : {"langevin", "andersen", "stochastic-rescaling", "nose-hoover-chain"}) {
        CAPTURE(type);
        const std::string text =
            changed(small_deck, {{"sample = true\n", "sample = true\nthermostat = { type = \"" + type + "\" }\n"}});
        CHECK(complaints(text + "[analysis]\nrdf = { every = 5 }\n").empty());
        const auto found = complaints(text + "[analysis]\nvacf = {}\n");
        const bool changes = type == "langevin" || type == "andersen";
        REQUIRE(found.size() == (changes ? 1 : 0));
        if (changes) {
            CHECK(found[0].severity == Severity::warning);
            CHECK_THAT(found[0].message, Contains("changes how atoms move"));
        }
    }
}
