#include "reference/canonical_size.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

const EquationOfState sized = equation_of_state("thol2016");

}  // namespace

TEST_CASE("pairs of N atoms are fewer by one part in N: the pressure of a thin gas has (N - 1)/N of its second term") {
    const double t = 1.5;
    const double rho = 1e-4;
    const double b2 = second_virial_coefficient(sized, t);
    const SizeShift shift = canonical_size_shift(sized, t, rho, 32, 0.0);
    CHECK(shift.pressure == Approx(-b2 * rho * rho * t / 32).epsilon(3e-3));
    // u = -rho T^2 dB2/dT, less the same part
    const double step = 1e-4;
    const double slope =
        (second_virial_coefficient(sized, t + step) - second_virial_coefficient(sized, t - step)) / (2.0 * step);
    CHECK(shift.potential_energy == Approx(rho * t * t * slope / 32).epsilon(3e-3));
    // an atom inserted between N meets them all
    CHECK(std::abs(shift.excess_chemical_potential) < 1e-3 * std::abs(2.0 * b2 * rho * t) / 32);
}

TEST_CASE("the shifts are derivatives of one Helmholtz energy") {
    const double t = GENERATE(0.8, 1.5, 4.0);
    const double rho = GENERATE(0.01, 0.75, 0.84);
    const double tail = -0.3;
    CAPTURE(t, rho);
    const auto at = [&](double temperature, double density) {
        return canonical_size_shift(sized, temperature, density, 108, tail);
    };
    const double dt = 1e-3 * t;
    const double drho = 1e-3 * rho;
    const auto in_t = [&](double SizeShift::*member) {
        return (at(t + dt, rho).*member - at(t - dt, rho).*member) / (2.0 * dt);
    };
    const auto in_rho = [&](double SizeShift::*member) {
        return (at(t, rho + drho).*member - at(t, rho - drho).*member) / (2.0 * drho);
    };
    const SizeShift here = at(t, rho);
    // du/drho = (p - T dp/dT)/rho^2 at a given number of atoms
    const double scale = std::abs(here.potential_energy / rho) + std::abs(here.pressure) / (rho * rho);
    CHECK(in_rho(&SizeShift::potential_energy) ==
          Approx((here.pressure - t * here.thermal_pressure) / (rho * rho)).margin(1e-3 * scale));
    CHECK(here.heat_capacity_cv == Approx(in_t(&SizeShift::potential_energy)).epsilon(1e-3).margin(1e-5));
    CHECK(here.thermal_pressure == Approx(in_t(&SizeShift::pressure)).epsilon(1e-3).margin(1e-5));
    CHECK(here.bulk_modulus == Approx(rho * in_rho(&SizeShift::pressure)).epsilon(1e-3).margin(1e-5));
}

TEST_CASE("the shift falls as 1/N, and the tail counts where the fluid is compressible") {
    const SizeShift few = canonical_size_shift(sized, 1.4, 0.3, 100, 0.0);
    const SizeShift many = canonical_size_shift(sized, 1.4, 0.3, 1000, 0.0);
    CHECK(many.pressure == Approx(0.1 * few.pressure).epsilon(1e-12));
    CHECK(many.excess_chemical_potential == Approx(0.1 * few.excess_chemical_potential).epsilon(1e-12));
    CHECK(structure_factor_at_zero(sized, 1.4, 0.3, -0.3) < 0.8 * structure_factor_at_zero(sized, 1.4, 0.3, 0.0));
    CHECK(structure_factor_at_zero(sized, 1.4, 1e-6, 0.0) == Approx(1.0).epsilon(1e-4));
}

TEST_CASE("where the pressure falls with the density there is no shift") {
    CHECK_THROWS_AS(canonical_size_shift(sized, 1.0, 0.3, 864, 0.0), PhysicsError);
}
