#include <catch2/catch.hpp>

#include "ljmd/reference/equation_of_state.hpp"

using namespace ljmd;

TEST_CASE("Johnson, Zollweg and Gubbins: the critical point that the fit was made to have") {
    const EquationOfState equation = equation_of_state("johnson1993");
    const FluidProperties state = properties(equation, 1.313, 0.310);
    CHECK(state.pressure == Approx(0.1299).margin(5e-5));
    CHECK(state.pressure_density_slope == Approx(0.0).margin(1e-6));
    CHECK(state.pressure_density_curvature == Approx(0.0).margin(1e-5));
}
