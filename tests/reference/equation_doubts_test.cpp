#include "reference/equation_doubts.hpp"

#include "catch.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

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

TEST_CASE("doubts: outside of the range, and where the fluid separates") {
    CHECK(doubts(thol(), 1.0, 0.75).empty());
    CHECK(doubts(thol(), 1.0, 0.02).empty());
    CHECK(doubts(thol(), 2.0, 0.3).empty());
    CHECK_THAT(only_doubt(1.0, 0.3), Contains("coexist"));
    CHECK_THAT(only_doubt(0.5, 0.9), Contains("outside of 0.661 to 9"));
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
