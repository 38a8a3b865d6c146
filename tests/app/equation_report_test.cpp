#include "ljmd/app/equation_report.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;
using Json = nlohmann::json;

namespace {

EquationOfState thol() {
    return equation_of_state("thol2016");
}

/// Of thol2016, where there is exactly one.
std::string only_doubt(double temperature, double density) {
    const auto all = doubts(thol(), temperature, density);
    REQUIRE(all.size() == 1);
    return all.front();
}

}  // namespace

TEST_CASE("the report of a state has the numbers of the equation, in print and as JSON") {
    const FluidProperties state = properties(thol(), 1.0, 0.7);
    const Json json = Json::parse(state_json(thol(), 1.0, 0.7));
    CHECK(json["pressure"] == state.pressure);
    CHECK(json["potential_energy"] == state.potential_energy);
    CHECK(json["compressibility_factor"] == state.compressibility_factor);
    CHECK(json["heat_capacity_cv"] == state.heat_capacity_cv);
    CHECK(json["heat_capacity_cp"] == *state.heat_capacity_cp());
    CHECK(json["second_virial_coefficient"] == second_virial_coefficient(thol(), 1.0));
    const std::string table = state_table(thol(), 1.0, 0.7);
    CHECK_THAT(table, Contains("thol2016") && Contains("doi:10.1063/1.4945000") && Contains("epsilon/sigma^3"));
}

TEST_CASE("what a state has not is null, and a dash in print") {
    const Json json = Json::parse(state_json(thol(), 1.0, 0.0));
    CHECK(json["speed_of_sound"].is_null());
    CHECK_THAT(state_table(thol(), 1.0, 0.0), Contains("  -  sqrt(epsilon/m)"));
}

TEST_CASE("the report of coexistence has both phases") {
    const auto phases = coexistence(thol(), 0.9);
    const Json json = Json::parse(coexistence_json(thol(), 0.9));
    CHECK(json["liquid"]["density"] == phases->liquid.density);
    CHECK(json["vapour"]["density"] == phases->vapour.density);
    CHECK(json["heat_of_vaporisation"] == phases->heat_of_vaporisation());
    CHECK_THAT(coexistence_table(thol(), 0.9), Contains("liquid") && Contains("vapour") && Contains("0.752773"));
    CHECK_THROWS_AS(coexistence_table(thol(), 1.4), InputError);
    CHECK_THROWS_WITH(coexistence_json(thol(), 1.4),
                      Contains("1.4 is not below the critical temperature of thol2016, 1.32"));
}

TEST_CASE("doubts: outside of the range, and where the fluid separates") {
    CHECK(doubts(thol(), 1.0, 0.75).empty());
    CHECK(doubts(thol(), 1.0, 0.02).empty());
    CHECK(doubts(thol(), 2.0, 0.3).empty());
    CHECK_THAT(only_doubt(1.0, 0.3), Contains("coexist"));
    CHECK_THAT(only_doubt(0.5, 0.9), Contains("outside of 0.661 to 9"));
    CHECK(Json::parse(state_json(thol(), 1.0, 0.3))["warnings"] == Json(doubts(thol(), 1.0, 0.3)));
    CHECK(Json::parse(state_json(thol(), 1.0, 0.75))["warnings"] == Json::array());
}

TEST_CASE("doubts: above the density at which the full fluid freezes, two phases or the crystal are stable") {
    CHECK(doubts(thol(), 0.722, 0.8442).empty());
    CHECK(doubts(thol(), 0.722, 0.854).empty());
    CHECK(only_doubt(0.722, 0.855) ==
          "at temperature 0.722 fluid of density 0.8545 and crystal of density 0.9648 coexist (Mastny and de Pablo "
          "2007); "
          "in between thol2016 describes a metastable fluid");
    CHECK_THAT(only_doubt(0.722, 0.964), Contains("in between"));
    CHECK(
        only_doubt(0.722, 1.0) ==
        "at temperature 0.722 the fluid freezes at density 0.8545 and the crystal melts at 0.9648 (Mastny and de Pablo "
        "2007); above that the crystal is stable and thol2016 describes a metastable fluid");
    CHECK(Json::parse(state_json(thol(), 0.722, 1.0))["warnings"] == Json(doubts(thol(), 0.722, 1.0)));
    for (const EquationOfState& equation : all_equations_of_state()) {
        INFO(equation.name);  // the fluid of Thol 2015 is another one, and freezes elsewhere
        CHECK(doubts(equation, 0.722, 1.0).empty() == (equation.name == "thol2015"));
    }
    CHECK(doubts(thol(), 0.69, 0.87).empty());  // below the triple point no liquid freezes
}

TEST_CASE("doubts: a state beyond the fit that is frozen, too, is told both") {
    const auto both = doubts(equation_of_state("johnson1993"), 2.0, 1.3);
    REQUIRE(both.size() == 2);
    CHECK_THAT(both[0], Contains("is above 1.25"));
    CHECK_THAT(both[1], Contains("above that the crystal is stable"));
}

TEST_CASE("all equations are listed with their critical points") {
    const Json list = Json::parse(equations_json());
    const std::string table = equations_table();
    REQUIRE(list.size() == all_equations_of_state().size());
    for (const Json& row : list) {
        CHECK_THAT(table, Contains(row["model"].get<std::string>()));
        CHECK(row["critical_temperature"].get<double>() > row["lowest_temperature"].get<double>());
    }
}
