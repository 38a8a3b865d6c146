#include <limits>

#include "deck/deck_fixtures.hpp"
#include "ljmd/cli/commands.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "ljmd/reference/equation_report.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

TEST_CASE("eos prints the equations, coexistence, or a state, by what it is given") {
    CHECK(said([] { eos_command({}); }).out == equations_document().text);
    CHECK(said([] { eos_command({.json = true}); }).out == to_json(equations_document().data) + "\n");
    CHECK(said([] { eos_command({.temperature = 0.9}); }).out ==
          coexistence_document(equation_of_state("thol2016"), 0.9).text);
    CHECK(said([] { eos_command({.temperature = 0.9, .json = true}); }).out ==
          to_json(coexistence_document(equation_of_state("thol2016"), 0.9).data) + "\n");
    CHECK(said([] { eos_command({.temperature = 1.5, .density = 0.5}); }).out ==
          state_document(equation_of_state("thol2016"), 1.5, 0.5).text);
    CHECK(said([] { eos_command({.model = "thol2015", .temperature = 1.5, .density = 0.5, .json = true}); }).out ==
          to_json(state_document(equation_of_state("thol2015"), 1.5, 0.5).data) + "\n");
}

TEST_CASE("eos warns of doubtful numbers, and only of these") {
    CHECK(said([] { eos_command({.temperature = 1.5, .density = 0.5}); }).err.empty());
    CHECK(said([] { eos_command({.temperature = 0.9}); }).err.empty());
    CHECK_THAT(said([] { eos_command({.temperature = 0.9, .density = 0.5}); }).err,
               Contains("warning: ") && Contains("coexist"));
    CHECK_THAT(said([] { eos_command({.temperature = 0.722, .density = 1.0}); }).err,
               StartsWith("warning: at temperature 0.722 the fluid freezes at density 0.8545"));
    CHECK_THAT(said([] { eos_command({.temperature = 0.6}); }).err, Contains("warning: temperature 0.6 is outside"));
}

TEST_CASE("eos refuses what is no temperature, no density, no equation") {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double wrong : {0.0, -1.0, infinity, std::nan("")}) {
        CHECK_THROWS_AS(eos_command({.temperature = wrong}), InputError);
        CHECK_THROWS_AS(eos_command({.temperature = wrong, .density = 0.5}), InputError);
    }
    for (const double wrong : {-0.1, infinity, std::nan("")}) {
        CHECK_THROWS_AS(eos_command({.temperature = 1.0, .density = wrong}), InputError);
    }
    CHECK_THROWS_AS(eos_command({.density = 0.5}), InputError);
    CHECK_THROWS_AS(eos_command({.model = "ideal"}), InputError);
    CHECK_THROWS_AS(eos_command({.model = "thol2015"}), InputError);  // all are listed, whatever it says
}
