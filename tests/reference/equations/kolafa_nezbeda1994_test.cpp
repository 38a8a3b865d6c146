#include "catch.hpp"

#include "ljmd/detail/reference/equation_of_state.hpp"

using namespace ljmd;

TEST_CASE("Kolafa and Nezbeda: the values of their program") {
    const EquationOfState equation = equation_of_state("kolafa-nezbeda1994");
    // It is in Fortran, and holds the coefficients in single precision.
    CHECK(properties(equation, 1.3, 0.2).potential_energy == Approx(-1.5371511277396868).epsilon(2e-7));
    CHECK(properties(equation, 1.3, 0.4).potential_energy == Approx(-2.806016725054152).epsilon(4e-7));
    CHECK(properties(equation, 1.3, 0.2).pressure == Approx(0.12147936810578708).epsilon(4e-7));
    CHECK(properties(equation, 1.3, 0.4).pressure == Approx(0.11253334756806482).epsilon(6e-6));
}
