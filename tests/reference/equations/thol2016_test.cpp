#include "catch.hpp"

#include "ljmd/detail/reference/equation_of_state.hpp"

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

TEST_CASE("Thol 2016: response functions as by the program of Allen and Tildesley (2017), eos_lj.py") {
    struct Expected {
        double temperature, density, kappa, alpha, cp, w, mu;
    };
    for (const Expected& expected :
         {Expected{1.0, 0.75, 0.13493407, 0.54674531, 5.21685874, 4.77275557, -0.11584358},
          Expected{1.5, 0.5, 0.94187721, 1.25181378, 6.88786583, 2.77694124, 0.25485998},
          Expected{2.74, 0.55, 0.16306762, 0.24463611, 3.64868834, 4.72746235, -0.16429169}}) {
        INFO("temperature " << expected.temperature);
        const FluidProperties state = properties(equation_of_state("thol2016"), expected.temperature, expected.density);
        const auto near = [](double value) { return Approx(value).epsilon(2e-7); };
        CHECK(*state.isothermal_compressibility() == near(expected.kappa));
        CHECK(*state.thermal_expansion() == near(expected.alpha));
        CHECK(*state.heat_capacity_cp() == near(expected.cp));
        CHECK(*state.speed_of_sound() == near(expected.w));
        CHECK(*state.joule_thomson_coefficient() == near(expected.mu));
    }
}
