#include "ljmd/detail/reference/equation_of_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "ljmd/potentials/second_virial.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

double helmholtz(const EquationOfState& equation, double temperature, double density) {
    return equation.residual_helmholtz(temperature, density).value();
}

}  // namespace

TEST_CASE("equations of state are listed by name, in alphabetical order, each with its source") {
    const std::vector<std::string> names = plugin_names(all_equations_of_state());
    CHECK(std::ranges::is_sorted(names));
    const std::vector<std::string> at_least{"johnson1993", "kolafa-nezbeda1994", "thol2015", "thol2016"};
    CHECK(std::ranges::includes(names, at_least));
    for (const EquationOfState& equation : all_equations_of_state()) {
        CHECK_THAT(equation.source, Contains("doi:10."));
    }
}

TEST_CASE("properties are derivatives of the Helmholtz energy") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const double t : {0.8, 1.3, 3.0}) {
            for (const double rho : {0.05, 0.5, 0.85}) {
                INFO(equation.name << ", temperature " << t << ", density " << rho);
                const FluidProperties state = properties(equation, t, rho);
                const double h = 1e-5;
                const double a_rho = (helmholtz(equation, t, rho + h) - helmholtz(equation, t, rho - h)) / (2.0 * h);
                const double a_t = (helmholtz(equation, t + h, rho) - helmholtz(equation, t - h, rho)) / (2.0 * h);
                const auto near = [&](double value) { return Approx(value).epsilon(1e-6).margin(1e-6); };
                CHECK(state.compressibility_factor == near(1.0 + rho * a_rho));
                CHECK(state.pressure == near(rho * t * (1.0 + rho * a_rho)));
                CHECK(state.potential_energy == near(-t * t * a_t));
                CHECK(state.residual_helmholtz_energy == near(t * helmholtz(equation, t, rho)));
                const auto by_temperature = [&](auto member) {
                    return (properties(equation, t + h, rho).*member - properties(equation, t - h, rho).*member) /
                           (2.0 * h);
                };
                const auto by_density = [&](auto member) {
                    return (properties(equation, t, rho + h).*member - properties(equation, t, rho - h).*member) /
                           (2.0 * h);
                };
                CHECK(state.heat_capacity_cv == near(1.5 + by_temperature(&FluidProperties::potential_energy)));
                CHECK(state.pressure_temperature_slope == near(by_temperature(&FluidProperties::pressure)));
                CHECK(state.pressure_density_slope == near(by_density(&FluidProperties::pressure)));
                CHECK(state.pressure_density_curvature == near(by_density(&FluidProperties::pressure_density_slope)));
                // Gibbs and Duhem: d(mu)/d(rho) = (dp/drho)/rho.
                CHECK(by_density(&FluidProperties::excess_chemical_potential) + t / rho ==
                      near(state.pressure_density_slope / rho));
            }
        }
    }
}

TEST_CASE("a dilute gas is ideal, and its first correction the second virial coefficient") {
    const PairPotential full = PairPotential::lennard_jones("cut", {.radius = 2.5});
    const PairPotential shifted = PairPotential::lennard_jones("shifted", {.radius = 2.5});
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const double t : {0.8, 1.3, 3.0}) {
            INFO(equation.name << ", temperature " << t);
            const FluidProperties nothing = properties(equation, t, 0.0);
            CHECK(nothing.compressibility_factor == 1.0);
            CHECK(nothing.pressure == 0.0);
            CHECK(nothing.heat_capacity_cv == 1.5);
            CHECK(nothing.excess_chemical_potential == Approx(0.0).margin(1e-15));
            CHECK_FALSE(nothing.speed_of_sound());
            const double exact = equation.name == "thol2015" ? second_virial_coefficient(shifted, t)
                                                             : untruncated_second_virial_coefficient(full, t);
            // How closely the formulas were fitted to it; Thol 2015 was not.
            CHECK(second_virial_coefficient(equation, t) == Approx(exact).margin(0.06));
            CHECK((properties(equation, t, 1e-6).compressibility_factor - 1.0) / 1e-6 ==
                  Approx(second_virial_coefficient(equation, t)).margin(1e-3));
        }
    }
}

TEST_CASE("at any low density the properties are those of the virial series, to all digits") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const double t : {0.7, 1.3, 5.0}) {
            // The series in rho about zero, whose coefficients are sums of few terms without cancellation.
            const Taylor a = equation.residual_helmholtz(Taylor::x(t), Taylor::y(0.0));
            for (const double rho : {1e-15, 1e-12, 1e-10, 1e-8}) {
                INFO(equation.name << ", temperature " << t << ", density " << rho);
                const FluidProperties state = properties(equation, t, rho);
                const auto series = [&](double first, double second) {
                    return Approx(rho * (first + rho * second)).epsilon(2e-12).margin(0.0);
                };
                CHECK(state.residual_helmholtz_energy == series(t * a.derivative(0, 1), t * 0.5 * a.derivative(0, 2)));
                CHECK(state.potential_energy == series(-t * t * a.derivative(1, 1), -t * t * 0.5 * a.derivative(1, 2)));
                CHECK(state.excess_chemical_potential ==
                      series(t * 2.0 * a.derivative(0, 1), t * 1.5 * a.derivative(0, 2)));
                // One and 3/2 are added to these: their digits end at 1e-16.
                const auto with_ideal = [&](double ideal, double first, double second) {
                    return Approx(ideal + rho * (first + rho * second)).epsilon(1e-15).margin(0.0);
                };
                CHECK(state.compressibility_factor == with_ideal(1.0, a.derivative(0, 1), a.derivative(0, 2)));
                const double cv = -2.0 * t * a.derivative(1, 1) - t * t * a.derivative(2, 1);
                const double cp = -t * t * a.derivative(2, 1);
                if (rho < 1e-10) {  // the next term needs a fourth derivative
                    CHECK(state.residual_heat_capacity_cv == Approx(rho * cv).epsilon(2e-10).margin(0.0));
                    CHECK(*state.residual_heat_capacity_cp == Approx(rho * cp).epsilon(2e-10).margin(0.0));
                }
                if (rho < 1e-8) {
                    CHECK(state.heat_capacity_cv == with_ideal(1.5, cv, 0.0));
                }
            }
        }
    }
}

TEST_CASE("three fits of the full fluid agree where it is simple") {
    for (const double t : {1.5, 2.74, 4.0}) {
        for (const double rho : {0.1, 0.45, 0.8}) {
            INFO("temperature " << t << ", density " << rho);
            const FluidProperties thol = properties(equation_of_state("thol2016"), t, rho);
            for (const std::string other : {"johnson1993", "kolafa-nezbeda1994"}) {
                const FluidProperties state = properties(equation_of_state(other), t, rho);
                CHECK(state.compressibility_factor == Approx(thol.compressibility_factor).margin(0.02));
                CHECK(state.potential_energy == Approx(thol.potential_energy).margin(0.07));
            }
        }
    }
}

TEST_CASE("the liquid has a heat capacity at constant pressure and a speed of sound, an unstable state neither") {
    const FluidProperties liquid = properties(equation_of_state("thol2016"), 0.8, 0.8);
    const double squared = *liquid.heat_capacity_cp() / liquid.heat_capacity_cv * liquid.pressure_density_slope;
    CHECK(*liquid.speed_of_sound() == Approx(std::sqrt(squared)));
    CHECK(*liquid.heat_capacity_cp() > liquid.heat_capacity_cv);
    const FluidProperties unstable = properties(equation_of_state("thol2016"), 0.8, 0.5);
    CHECK(unstable.pressure_density_slope < 0.0);
    CHECK_FALSE(unstable.heat_capacity_cp());
    CHECK_FALSE(unstable.speed_of_sound());
    // A monatomic ideal gas: w^2 = 5/3 T.
    CHECK(*properties(equation_of_state("thol2016"), 2.0, 1e-9).speed_of_sound() ==
          Approx(std::sqrt(10.0 / 3.0)).epsilon(1e-7));
}

namespace {

/// df/dx by central differences of order h^6.
template <class Function>
double slope(const Function& f, double x, double h) {
    return (45.0 * (f(x + h) - f(x - h)) - 9.0 * (f(x + 2 * h) - f(x - 2 * h)) + (f(x + 3 * h) - f(x - 3 * h))) /
           (60.0 * h);
}

/// States where all equations have a stable gas or liquid.
const std::vector<std::pair<double, double>> stable_states{{0.8, 0.001}, {0.8, 0.85}, {1.0, 0.75}, {1.5, 0.05},
                                                           {1.5, 0.5},   {3.0, 0.3},  {3.0, 0.9}};

}  // namespace

TEST_CASE("response functions are derivatives of volume, enthalpy and energy, to 1e-8") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const auto& [temperature, density] : stable_states) {
            const double t = temperature;
            const double rho = density;
            INFO(equation.name << ", temperature " << t << ", density " << rho);
            const FluidProperties state = properties(equation, t, rho);
            const auto pressure = [&](double at, double of) { return properties(equation, at, of).pressure; };
            const double p_rho = slope([&](double of) { return pressure(t, of); }, rho, 2e-3 * rho);
            const double p_t = slope([&](double at) { return pressure(at, rho); }, t, 2e-3 * t);
            const auto enthalpy = [&](double at, double of) {
                const FluidProperties there = properties(equation, at, of);
                return there.potential_energy + 1.5 * at + there.pressure / of;
            };
            const double h_rho = slope([&](double of) { return enthalpy(t, of); }, rho, 2e-3 * rho);
            const double h_t = slope([&](double at) { return enthalpy(at, rho); }, t, 2e-3 * t);
            const auto near = [](double value) { return Approx(value).epsilon(1e-8).margin(1e-8); };
            CHECK(*state.isothermal_compressibility() == near(1.0 / (rho * p_rho)));
            CHECK(*state.thermal_expansion() == near(p_t / (rho * p_rho)));
            // At constant pressure and at constant enthalpy the density follows the temperature.
            CHECK(*state.heat_capacity_cp() == near(h_t - h_rho * p_t / p_rho));
            CHECK(*state.joule_thomson_coefficient() == near(1.0 / (p_t - p_rho * h_t / h_rho)));
        }
    }
}

TEST_CASE("the identities of thermodynamics hold to round-off") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const auto& [t, rho] : stable_states) {
            INFO(equation.name << ", temperature " << t << ", density " << rho);
            const FluidProperties state = properties(equation, t, rho);
            const double kappa = *state.isothermal_compressibility();
            const double alpha = *state.thermal_expansion();
            const double cp = *state.heat_capacity_cp();
            CHECK(cp - state.heat_capacity_cv == Approx(t * alpha * alpha / (kappa * rho)).epsilon(1e-12));
            const double adiabatic = kappa * state.heat_capacity_cv / cp;
            CHECK(*state.speed_of_sound() == Approx(1.0 / std::sqrt(rho * adiabatic)).epsilon(1e-12));
            CHECK(*state.joule_thomson_coefficient() ==
                  Approx((t * alpha - 1.0) / (rho * cp)).epsilon(1e-9).margin(1e-9 / rho * 1e-6));
            CHECK(state.residual_heat_capacity_cv == Approx(state.heat_capacity_cv - 1.5).epsilon(0.0).margin(1e-14));
            CHECK(*state.residual_heat_capacity_cp == Approx(cp - 2.5).epsilon(0.0).margin(1e-12));
        }
    }
}

TEST_CASE("in the limit of low density the gas is ideal, and the Joule-Thomson coefficient that of the second virial") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        for (const double t : {0.8, 1.5, 6.0}) {
            INFO(equation.name << ", temperature " << t);
            const double rho = 1e-12;
            const FluidProperties gas = properties(equation, t, rho);
            CHECK(*gas.isothermal_compressibility() * rho * t == Approx(1.0).epsilon(1e-9));
            CHECK(*gas.thermal_expansion() * t == Approx(1.0).epsilon(1e-9));
            const double b = second_virial_coefficient(equation, t);
            const double b_slope =
                slope([&](double at) { return second_virial_coefficient(equation, at); }, t, 2e-3 * t);
            CHECK(*gas.joule_thomson_coefficient() == Approx((t * b_slope - b) / 2.5).epsilon(1e-8));
        }
    }
}

TEST_CASE("residual heat capacities of gases are those of exact arithmetic") {
    struct Exact {
        std::string equation;
        double temperature, density, cv, cp;
    };
    for (const Exact& exact :  // with 60 digits (mpmath)
         {Exact{"thol2016", 1.3, 1e-10, 2.89238829087683e-10, 1.53342301649774e-9},
          Exact{"thol2016", 0.8, 1e-6, 1.03429613250082e-5, 3.73606236970886e-5},
          Exact{"thol2016", 1.5, 1e-3, 0.00208842460955088, 0.0122688347982937},
          Exact{"thol2015", 1.3, 1e-10, 2.62399662862162e-10, 1.31163997480839e-9},
          Exact{"kolafa-nezbeda1994", 1.3, 1e-10, 2.87088941058953e-10, 1.52861847170744e-9},
          Exact{"johnson1993", 1.3, 1e-10, 2.86681435190805e-10, 1.52724910153011e-9},
          Exact{"johnson1993", 1.5, 1e-3, 0.0020368224096819, 0.0121920228243868}}) {
        INFO(exact.equation << ", density " << exact.density);
        const FluidProperties gas = properties(equation_of_state(exact.equation), exact.temperature, exact.density);
        CHECK(gas.residual_heat_capacity_cv == Approx(exact.cv).epsilon(1e-12));
        CHECK(*gas.residual_heat_capacity_cp == Approx(exact.cp).epsilon(1e-12));
    }
}

TEST_CASE(
    "a dilute gas is neither warmed nor cooled by throttling at the inversion temperature of Lennard-Jones atoms") {
    // T B2' = B2: 6.430798 by the exact second virial coefficient, S. Stephan and U. K. Deiters, Int. J. Thermophys.
    // 41, 147 (2020), doi:10.1007/s10765-020-02721-9.
    const PairPotential full = PairPotential::lennard_jones("cut", {.radius = 2.5});
    const double inversion = 6.430798;
    const auto exact = [&](double t) { return untruncated_second_virial_coefficient(full, t); };
    CHECK(inversion * slope(exact, inversion, 0.05) == Approx(exact(inversion)).epsilon(1e-6));
    for (const std::string name : {"johnson1993", "kolafa-nezbeda1994", "thol2016"}) {
        INFO(name);
        const EquationOfState equation = equation_of_state(name);
        CHECK(*properties(equation, 0.93 * inversion, 1e-9).joule_thomson_coefficient() > 0.0);
        CHECK(*properties(equation, 1.07 * inversion, 1e-9).joule_thomson_coefficient() < 0.0);
    }
}

TEST_CASE("an unstable state and density zero have no response functions") {
    const EquationOfState equation = equation_of_state("thol2016");
    for (const double rho : {0.0, 0.5}) {
        const FluidProperties state = properties(equation, 0.8, rho);
        CHECK_FALSE(state.isothermal_compressibility());
        CHECK_FALSE(state.thermal_expansion());
        CHECK_FALSE(state.joule_thomson_coefficient());
        CHECK_FALSE(state.residual_heat_capacity_cp);
    }
}

TEST_CASE("states outside of what an equation was fitted to are told") {
    const auto range = [](const std::string& name, double t, double rho) {
        return outside_of_range(equation_of_state(name), properties(equation_of_state(name), t, rho));
    };
    CHECK(range("thol2016", 0.722, 0.8442).empty());
    CHECK(range("thol2016", 0.6, 0.8442) == "temperature 0.6 is outside of 0.661 to 9, where thol2016 was fitted");
    CHECK_THAT(range("thol2016", 9.5, 0.5), Contains("temperature 9.5"));
    CHECK_THAT(range("thol2016", 5.0, 1.3), Contains("pressure") && Contains("is above 65"));
    CHECK(range("johnson1993", 2.0, 1.3) == "density 1.3 is above 1.25, up to which johnson1993 was fitted");
}

TEST_CASE("where a formula gives nothing finite, that is said") {
    // Hard spheres of packing fraction above 1.
    CHECK_THROWS_WITH(
        properties(equation_of_state("kolafa-nezbeda1994"), 1.0, 3.0),
        "kolafa-nezbeda1994 gives no pressure at temperature 1 and density 3: too far from where it holds");
}
