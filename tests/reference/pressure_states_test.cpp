#include "ljmd/reference/pressure_states.hpp"

#include <cmath>
#include <string>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

double gibbs(const FluidProperties& state) {
    return state.temperature * std::log(state.density) + state.excess_chemical_potential;
}

}  // namespace

TEST_CASE("a state from a pressure has that pressure, over fourteen orders of magnitude") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const double t : {0.75, 1.0, 1.5, 3.0, 6.0}) {
            for (const double p : {1e-12, 1e-6, 1e-3, 0.05, 0.5, 5.0}) {
                INFO(equation.name << ", temperature " << t << ", pressure " << p);
                const auto phases = states_at_pressure(equation, t, p);
                REQUIRE_FALSE(phases.empty());
                CHECK(phases.front().gibbs_energy_difference == 0.0);
                for (const PhaseAtPressure& phase : phases) {
                    // A liquid's pressure is a difference of large numbers.
                    const double margin = std::string(phase.name) == "liquid" ? 3e-12 : 0.0;
                    CHECK(phase.state.pressure == Approx(p).epsilon(1e-9).margin(margin));
                    CHECK(phase.state.pressure_density_slope > 0.0);
                }
            }
        }
    }
}

TEST_CASE("a dilute gas has the density of the ideal one") {
    const auto gas = states_at_pressure(equation_of_state("thol2016"), 2.0, 1e-9);
    REQUIRE(gas.size() == 1);
    CHECK(std::string(gas[0].name) == "fluid");
    CHECK(gas[0].state.density == Approx(5e-10).epsilon(1e-8));
}

TEST_CASE("the density comes back from the pressure of a state") {
    const EquationOfState equation = equation_of_state("thol2016");
    for (const double t : {0.722, 1.1, 1.5, 5.0}) {
        for (const double rho : {1e-4, 0.01, 0.6, 0.8442, 0.95}) {
            const FluidProperties state = properties(equation, t, rho);
            const auto ends = spinodals(equation, t);
            if (state.pressure <= 0.0 || (ends && rho > ends->vapour && rho < ends->liquid)) {
                continue;
            }
            INFO("temperature " << t << ", density " << rho);
            bool found = false;
            for (const PhaseAtPressure& phase : states_at_pressure(equation, t, state.pressure)) {
                found = found || std::abs(phase.state.density / rho - 1.0) < 1e-9;
            }
            CHECK(found);
        }
    }
}

TEST_CASE("below the vapour pressure the vapour is stable, above it the liquid, and the other is metastable") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        const double t = 0.9 * critical_point(equation).temperature;
        const double saturated = coexistence(equation, t)->pressure;
        for (const double factor : {0.9, 1.1}) {
            INFO(equation.name << ", " << factor);
            const auto phases = states_at_pressure(equation, t, factor * saturated);
            REQUIRE(phases.size() == 2);
            CHECK(std::string(phases[0].name) == (factor < 1.0 ? "vapour" : "liquid"));
            CHECK(std::string(phases[1].name) == (factor < 1.0 ? "liquid" : "vapour"));
            CHECK(phases[1].gibbs_energy_difference ==
                  Approx(gibbs(phases[1].state) - gibbs(phases[0].state)).epsilon(1e-12));
            CHECK(phases[1].gibbs_energy_difference > 0.0);
            // dG/dp = 1/rho: along 10 % of the pressure, nearly the difference of the volumes.
            CHECK(phases[1].gibbs_energy_difference ==
                  Approx(0.1 * saturated * std::abs(1.0 / phases[1].state.density - 1.0 / phases[0].state.density))
                      .epsilon(0.25));
        }
    }
}

TEST_CASE("at the vapour pressure both phases are those of coexistence, with one Gibbs energy") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const double part : {0.7, 0.9, 0.99}) {
            INFO(equation.name << ", " << part);
            const double t = part * critical_point(equation).temperature;
            const auto both = coexistence(equation, t);
            const auto phases = states_at_pressure(equation, t, both->pressure);
            REQUIRE(phases.size() == 2);
            CHECK(phases[1].gibbs_energy_difference == Approx(0.0).margin(1e-9));
            CHECK(phases[0].state.density + phases[1].state.density ==
                  Approx(both->liquid.density + both->vapour.density).epsilon(1e-7));
        }
    }
}

TEST_CASE("beyond the spinodals one phase is left, above the critical temperature there is one fluid") {
    const EquationOfState equation = equation_of_state("thol2016");
    const auto ends = spinodals(equation, 0.9);
    const double highest = properties(equation, 0.9, ends->vapour).pressure;
    CHECK(states_at_pressure(equation, 0.9, 0.999 * highest).size() == 2);
    const auto above = states_at_pressure(equation, 0.9, 1.001 * highest);
    REQUIRE(above.size() == 1);
    CHECK(std::string(above[0].name) == "liquid");
    CHECK_FALSE(spinodals(equation, 1.4).has_value());
    CHECK(std::string(states_at_pressure(equation, 1.4, 0.2).front().name) == "fluid");
    CHECK_THROWS_AS(states_at_pressure(equation, 1.0, 1e9), PhysicsError);
}

TEST_CASE("coexistence at a pressure is that at its temperature") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        const CriticalPoint critical = critical_point(equation);
        for (const double part : {0.7, 0.999}) {
            INFO(equation.name << ", " << part);
            const auto at_temperature = coexistence(equation, part * critical.temperature);
            const Coexistence found = coexistence_at_pressure(equation, at_temperature->pressure);
            CHECK(found.liquid.temperature == Approx(part * critical.temperature).epsilon(1e-9));
            CHECK(found.pressure == Approx(at_temperature->pressure).epsilon(1e-9));
            CHECK(found.vapour.density == Approx(at_temperature->vapour.density).epsilon(1e-6));
        }
        CHECK_THROWS_WITH(coexistence_at_pressure(equation, critical.pressure),
                          Contains("is not below the critical pressure of " + equation.name));
        CHECK_THROWS_AS(coexistence_at_pressure(equation, 1e-30), PhysicsError);
    }
}

TEST_CASE("the vapour pressure grows as Clausius and Clapeyron say") {
    const EquationOfState equation = equation_of_state("thol2016");
    const double p = 0.01;
    const double h = 1e-4;
    const Coexistence both = coexistence_at_pressure(equation, p);
    const double slope = 2.0 * h * p /
                         (coexistence_at_pressure(equation, (1.0 + h) * p).liquid.temperature -
                          coexistence_at_pressure(equation, (1.0 - h) * p).liquid.temperature);
    CHECK(slope == Approx(both.heat_of_vaporisation() /
                          (both.liquid.temperature * (1.0 / both.vapour.density - 1.0 / both.liquid.density)))
                       .epsilon(1e-6));
}
