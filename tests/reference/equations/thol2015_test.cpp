#include <catch2/catch.hpp>

#include "ljmd/reference/equation_of_state.hpp"

using namespace ljmd;

TEST_CASE("Thol 2015: the values in the guide to the programs of Allen and Tildesley (2017)") {
    const EquationOfState equation = equation_of_state("thol2015");
    const FluidProperties state = properties(equation, 1.0, 0.75);
    CHECK(state.potential_energy + 1.5 == Approx(-2.9286).margin(1e-4));
    CHECK(state.pressure == Approx(0.9897).margin(5e-5));
    CHECK(state.heat_capacity_cv == Approx(2.2787).margin(5e-5));
}

TEST_CASE("Thol 2015 has the critical point that its authors built in, to the digits of its coefficients") {
    const EquationOfState equation = equation_of_state("thol2015");
    const FluidProperties state = properties(equation, 1.086, 0.319);
    CHECK(state.pressure == Approx(0.1008).margin(5e-5));
    CHECK(state.pressure_density_slope == Approx(0.0).margin(1e-6));
    CHECK(state.pressure_density_curvature == Approx(0.0).margin(1e-5));
}
