#include "catch.hpp"

#include "ljmd/detail/reference/equation_of_state.hpp"

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

TEST_CASE("Thol 2015: response functions as by the program of Allen and Tildesley (2017), eos_lj.py") {
    struct Expected {
        double temperature, density, kappa, alpha, cp, w, mu;
    };
    for (const Expected& expected :
         {Expected{1.0, 0.75, 0.11725677, 0.47484893, 4.84269753, 4.91583374, -0.14458913},
          Expected{1.5, 0.5, 0.62482998, 0.83778225, 5.25307209, 2.98813313, 0.09772315},
          Expected{2.74, 0.55, 0.14731587, 0.22158380, 3.47657853, 4.86061661, -0.20545822}}) {
        INFO("temperature " << expected.temperature);
        const FluidProperties state = properties(equation_of_state("thol2015"), expected.temperature, expected.density);
        const auto near = [](double value) { return Approx(value).epsilon(2e-7); };
        CHECK(*state.isothermal_compressibility() == near(expected.kappa));
        CHECK(*state.thermal_expansion() == near(expected.alpha));
        CHECK(*state.heat_capacity_cp() == near(expected.cp));
        CHECK(*state.speed_of_sound() == near(expected.w));
        CHECK(*state.joule_thomson_coefficient() == near(expected.mu));
    }
}
