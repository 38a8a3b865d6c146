#include "ljmd/engine/choices.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

TEST_CASE("plug-ins are chosen by name, with the options that are given and defaults for the others") {
    CHECK(integrator("leapfrog").name == "leapfrog");
    CHECK(thermostat("rescale", {{"every", 5}}).settings == Settings{{"every", 5}});
    CHECK(thermostat("langevin", {{"time", 0.5}}).settings != thermostat("langevin").settings);
    CHECK(thermostat("langevin", {{"time", 2}}).settings == thermostat("langevin", {{"time", 2.0}}).settings);
    CHECK(barostat("stochastic-cell-rescaling", {{"pressure", 1.0}}).name == "stochastic-cell-rescaling");
    CHECK(analysis("rdf", {{"bins", 50}}).settings != analysis("rdf").settings);
}

TEST_CASE("a wrong choice is told in one message, with what is allowed") {
    CHECK_THROWS_WITH(thermostat("nose"), Contains("unknown thermostat 'nose'") && Contains("langevin"));
    CHECK_THROWS_WITH(analysis("gr"), Contains("unknown analysis 'gr'") && Contains("rdf"));
    CHECK_THROWS_WITH(thermostat("langevin", {{"tim", 0.5}}), Contains("'tim'") && Contains("time"));
    CHECK_THROWS_WITH(thermostat("langevin", {{"time", -1.0}}), Contains("'time' in langevin") && Contains("> 0"));
    CHECK_THROWS_WITH(thermostat("rescale", {{"every", "often"}}), Contains("must be an integer, found a string"));
    CHECK_THROWS_AS(integrator("leapfrog", {{"every", 1}}), InputError);
    CHECK_THROWS_WITH(thermostat("langevin", {{"time", 0.5}, {"time", 0.6}}),
                      Contains("'time' in langevin is given twice"));
}
