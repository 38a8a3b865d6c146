#include "ljmd/detail/reference/phase_equilibrium.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("critical points are those that the papers give") {
    struct Published {
        std::string name;
        double temperature, density, pressure;
    };
    // Thol's equations and Johnson's were made to have theirs there. Isotherms are flat: the density is the least
    // certain.
    for (const Published& published : {Published{"thol2016", 1.32, 0.31, 0.13006},
                                       {"thol2015", 1.086, 0.319, 0.1008},
                                       {"johnson1993", 1.313, 0.310, 0.1299},
                                       {"kolafa-nezbeda1994", 1.3396, 0.3108, 0.1405}}) {
        INFO(published.name);
        const CriticalPoint point = critical_point(equation_of_state(published.name));
        CHECK(point.temperature == Approx(published.temperature).margin(6e-5));
        CHECK(point.density == Approx(published.density).margin(4e-3));
        CHECK(point.pressure == Approx(published.pressure).margin(6e-5));
        const FluidProperties there = properties(equation_of_state(published.name), point.temperature, point.density);
        CHECK(std::abs(there.pressure_density_slope) < 1e-8);
        CHECK(std::abs(there.pressure_density_curvature) < 1e-3);
    }
}

TEST_CASE("above the critical temperature of Thol 2016 every isotherm rises, below it none does") {
    const EquationOfState thol = equation_of_state("thol2016");
    const double critical = critical_point(thol).temperature;
    const auto min_slope = [&](double temperature) {
        double least = 1.0;
        for (double density = 0.01; density < 0.9; density += 0.001) {
            least = std::min(least, properties(thol, temperature, density).pressure_density_slope);
        }
        return least;
    };
    CHECK(min_slope(critical + 1e-4) > 0.0);
    CHECK(min_slope(critical - 1e-4) < 0.0);
}

TEST_CASE("coexisting phases have one pressure and one chemical potential, and are stable") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        const double critical = critical_point(equation).temperature;
        for (const double part : {0.6, 0.7, 0.9, 0.99, 0.9999}) {
            const double t = part * critical;
            INFO(equation.name << ", temperature " << t);
            const auto found = coexistence(equation, t);
            REQUIRE(found);
            const auto& [pressure, liquid, vapour] = *found;
            CHECK(liquid.density > vapour.density);
            CHECK(liquid.pressure == Approx(pressure).epsilon(1e-9).margin(1e-13));
            CHECK(vapour.pressure == Approx(pressure).epsilon(1e-9));
            CHECK(t * std::log(liquid.density / vapour.density) + liquid.excess_chemical_potential ==
                  Approx(vapour.excess_chemical_potential).margin(1e-9));
            CHECK(liquid.pressure_density_slope > 0.0);
            CHECK(vapour.pressure_density_slope > 0.0);
            CHECK(found->heat_of_vaporisation() > 0.0);
        }
    }
}

TEST_CASE("coexistence obeys Clausius and Clapeyron") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        const double t = 0.95;
        const double h = 1e-4;
        INFO(equation.name);
        const auto found = coexistence(equation, t);
        const double slope =
            (coexistence(equation, t + h)->pressure - coexistence(equation, t - h)->pressure) / (2.0 * h);
        const double volume_gained = 1.0 / found->vapour.density - 1.0 / found->liquid.density;
        CHECK(slope == Approx(found->heat_of_vaporisation() / (t * volume_gained)).epsilon(1e-6));
    }
}

TEST_CASE("Thol 2016 at coexistence: values of other programs") {
    struct Row {
        double t, liquid, vapour, pressure, energy;
    };
    for (const Row& row :
         {Row{0.70, 0.84265, 0.001992, 0.001367, -6.0954}, Row{0.80, 0.79903, 0.006084, 0.004634, -5.7111},
          Row{1.00, 0.70182, 0.029452, 0.024885, -4.9013}, Row{1.20, 0.56562, 0.097923, 0.076875, -3.8788}}) {
        const auto found = coexistence(equation_of_state("thol2016"), row.t);
        CHECK(found->liquid.density == Approx(row.liquid).margin(6e-6));
        CHECK(found->vapour.density == Approx(row.vapour).margin(6e-7));
        CHECK(found->pressure == Approx(row.pressure).margin(6e-7));
        CHECK(found->liquid.potential_energy == Approx(row.energy).margin(6e-5));
    }
}

TEST_CASE("at and above the critical temperature nothing coexists") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        INFO(equation.name);
        const double critical = critical_point(equation).temperature;
        CHECK_FALSE(coexistence(equation, critical + 1e-6));
        CHECK_FALSE(coexistence(equation, 2.0));
        CHECK(coexistence(equation, critical - 1e-4));
    }
}

TEST_CASE("an equation that has no liquid at a temperature says so") {
    CHECK_THROWS_WITH(coexistence(equation_of_state("johnson1993"), 0.6),
                      "johnson1993 has no stable liquid or vapour at temperature 0.6: it was fitted from 0.7 to 6");
}
