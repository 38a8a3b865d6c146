#include "reference/equation_report.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "reference/equation_doubts.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

EquationOfState reported() {
    return equation_of_state("thol2016");
}

}  // namespace

TEST_CASE("the report of a state has the numbers of the equation, in print and as JSON") {
    const FluidProperties state = properties(reported(), 1.0, 0.7);
    const Data json = state_document(reported(), 1.0, 0.7).data;
    CHECK(json["pressure"] == state.pressure);
    CHECK(json["potential_energy"] == state.potential_energy);
    CHECK(json["compressibility_factor"] == state.compressibility_factor);
    CHECK(json["heat_capacity_cv"] == state.heat_capacity_cv);
    CHECK(json["heat_capacity_cp"] == *state.heat_capacity_cp());
    CHECK(json["second_virial_coefficient"] == second_virial_coefficient(reported(), 1.0));
    const std::string table = state_document(reported(), 1.0, 0.7).text;
    CHECK_THAT(table, Contains("thol2016") && Contains("doi:10.1063/1.4945000") && Contains("epsilon/sigma^3"));
}

TEST_CASE("what a state has not is null, and a dash in print") {
    const Data json = state_document(reported(), 1.0, 0.0).data;
    CHECK(json["speed_of_sound"].is_null());
    CHECK_THAT(state_document(reported(), 1.0, 0.0).text, Contains("  -  sqrt(epsilon/m)"));
}

TEST_CASE("the report of coexistence has both phases") {
    const auto phases = coexistence(reported(), 0.9);
    const Data json = coexistence_document(reported(), 0.9).data;
    CHECK(json["liquid"]["density"] == phases->liquid.density);
    CHECK(json["vapour"]["density"] == phases->vapour.density);
    CHECK(json["heat_of_vaporisation"] == phases->heat_of_vaporisation());
    CHECK_THAT(coexistence_document(reported(), 0.9).text,
               Contains("liquid") && Contains("vapour") && Contains("0.752773"));
    CHECK_THROWS_AS(coexistence_document(reported(), 1.4), InputError);
    CHECK_THROWS_WITH(coexistence_document(reported(), 1.4),
                      Contains("1.4 is not below the critical temperature of thol2016, 1.32"));
}

TEST_CASE("the report of a state tells why not to rely on it") {
    CHECK(state_document(reported(), 1.0, 0.3).data["warnings"] == Data(doubts(reported(), 1.0, 0.3)));
    CHECK(state_document(reported(), 0.722, 1.0).data["warnings"] == Data(doubts(reported(), 0.722, 1.0)));
    CHECK(state_document(reported(), 1.0, 0.75).data["warnings"] == Data::list());
}

TEST_CASE("all equations are listed with their critical points") {
    const Data list = equations_document().data;
    const std::string table = equations_document().text;
    REQUIRE(list.size() == all_equations_of_state().size());
    for (const Data& row : list.items()) {
        CHECK_THAT(table, Contains(row["model"].text()));
        CHECK(row["critical_temperature"].number() > row["lowest_temperature"].number());
    }
}
