#include <cmath>
#include "catch.hpp"

#include "ljmd/detail/reference/equation_of_state.hpp"

using namespace ljmd;

TEST_CASE("Johnson, Zollweg and Gubbins: the critical point that the fit was made to have") {
    const EquationOfState equation = equation_of_state("johnson1993");
    const FluidProperties state = properties(equation, 1.313, 0.310);
    CHECK(state.pressure == Approx(0.1299).margin(5e-5));
    CHECK(state.pressure_density_slope == Approx(0.0).margin(1e-6));
    CHECK(state.pressure_density_curvature == Approx(0.0).margin(1e-5));
}

TEST_CASE("Johnson, Zollweg and Gubbins: both ways to the integrals over the density meet") {
    // Where gamma rho^2 = 6, and the recursion changes its direction.
    const EquationOfState equation = equation_of_state("johnson1993");
    const double rho = std::sqrt(2.0);
    const FluidProperties below = properties(equation, 3.0, std::nextafter(rho, 0.0));
    const FluidProperties above = properties(equation, 3.0, std::nextafter(rho, 2.0));
    CHECK(below.pressure == Approx(above.pressure).epsilon(1e-12));
    CHECK(below.potential_energy == Approx(above.potential_energy).margin(1e-11));
    CHECK(below.pressure_density_curvature == Approx(above.pressure_density_curvature).epsilon(1e-11));
}
