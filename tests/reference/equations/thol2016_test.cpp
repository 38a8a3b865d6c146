#include <catch2/catch.hpp>

#include "ljmd/reference/equation_of_state.hpp"

using namespace ljmd;

TEST_CASE("Thol 2016: the values in the guide to the programs of Allen and Tildesley (2017)") {
    const EquationOfState equation = equation_of_state("thol2016");
    const FluidProperties state = properties(equation, 1.0, 0.75);
    CHECK(state.potential_energy + 1.5 == Approx(-3.7212).margin(5e-5));
    CHECK(state.pressure == Approx(0.3996).margin(5e-5));
    CHECK(state.heat_capacity_cv == Approx(2.2630).margin(5e-5));
}

TEST_CASE("Thol 2016 has the critical point that its authors built in, to the digits of its coefficients") {
    // A term that circulates with a misprint (-0.099 for -9.92) changes these slopes by 0.01 and 0.06.
    const EquationOfState equation = equation_of_state("thol2016");
    const FluidProperties state = properties(equation, 1.32, 0.31);
    CHECK(state.pressure == Approx(0.13006).margin(5e-6));
    CHECK(state.pressure_density_slope == Approx(0.0).margin(1e-6));
    CHECK(state.pressure_density_curvature == Approx(0.0).margin(2e-4));
}
