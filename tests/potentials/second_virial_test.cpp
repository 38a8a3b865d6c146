#include "ljmd/potentials/second_virial.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "potentials/made_potential.hpp"

using namespace ljmd;
using test::made_potential;

namespace {

using std::numbers::pi;
constexpr double rc = 2.5;

/// -2 pi times the integral of (exp(-u/T) - 1) r^2 by the midpoint rule, as a second opinion on the quadrature.
double by_midpoints(const PairPotential& potential, double temperature, double a, double b) {
    constexpr int parts = 200'000;
    const double h = (b - a) / parts;
    double sum = 0.0;
    for (int i = 0; i < parts; ++i) {
        const double r = a + (i + 0.5) * h;
        sum += std::expm1(-potential(r).u / temperature) * r * r;
    }
    return -2.0 * pi * sum * h;
}

}  // namespace

TEST_CASE("the second virial coefficient of Lennard-Jones is that of its series, from 0.5 to 100") {
    const PairPotential potential = PairPotential::lennard_jones("cut", {.radius = rc});
    std::ifstream file(LJMD_TEST_DATA "/second_virial_lennard_jones.csv");
    std::string header;
    std::getline(file, header);
    REQUIRE(header == "T,B2");
    int rows = 0;
    double temperature = 0.0;
    double expected = 0.0;
    for (char comma = 0; file >> temperature >> comma >> expected; ++rows) {
        INFO("temperature " << temperature);
        const double scale = std::max(1.0, std::abs(expected));
        // At the Boyle temperature the table gives its temperature in nine digits only.
        const double tolerance = std::abs(expected) < 1e-10 ? 1e-8 : 1e-10 * scale;
        CHECK(std::abs(untruncated_second_virial_coefficient(potential, temperature) - expected) < tolerance);
    }
    CHECK(rows == 36);
}

TEST_CASE("the Boyle temperature of Lennard-Jones") {
    const PairPotential potential = PairPotential::lennard_jones("cut", {.radius = rc});
    CHECK(boyle_temperature(potential) == Approx(3.417928023049).epsilon(1e-11));
}

TEST_CASE("every formula and truncation has the second virial coefficient of its pair energy") {
    for (const std::string& formula : PairPotential::formula_names()) {
        for (const std::string& truncation : PairPotential::truncation_names()) {
            const PairPotential potential = made_potential(formula, truncation, {.radius = rc, .switch_start = 2.0});
            for (const double temperature : {0.7, 2.0}) {
                INFO(formula << ", " << truncation << ", temperature " << temperature);
                if (potential(1e-3).u < -1e3) {  // atoms that meet fall into each other
                    CHECK_THROWS_AS(second_virial_coefficient(potential, temperature), PhysicsError);
                    continue;
                }
                CHECK(second_virial_coefficient(potential, temperature) ==
                      Approx(by_midpoints(potential, temperature, 0.0, rc)).epsilon(1e-8));
            }
        }
    }
}

TEST_CASE("a cutoff far out changes the second virial coefficient by what lies beyond it") {
    const double temperature = 1.3;
    const PairPotential near = PairPotential::lennard_jones("cut", {.radius = rc});
    const PairPotential far = PairPotential::lennard_jones("cut", {.radius = 40.0});
    CHECK(second_virial_coefficient(far, temperature) - second_virial_coefficient(near, temperature) ==
          Approx(by_midpoints(far, temperature, rc, 40.0)).epsilon(1e-8));
    // Beyond 40 the energy is small: -2 pi * integral of -u/T r^2.
    CHECK(untruncated_second_virial_coefficient(far, temperature) - second_virial_coefficient(far, temperature) ==
          Approx(-8.0 * pi / (3.0 * temperature) * std::pow(40.0, -3)).epsilon(1e-5));
}

TEST_CASE("purely repulsive atoms have a positive second virial coefficient that falls with temperature") {
    const PairPotential wca = PairPotential::lennard_jones("shifted", {.radius = std::pow(2.0, 1.0 / 6.0)});
    const double cold = second_virial_coefficient(wca, 0.5);
    const double hot = second_virial_coefficient(wca, 2.0);
    CHECK(cold > hot);
    CHECK(hot > 0.0);
    CHECK(cold < 2.0 * pi / 3.0 * std::pow(2.0, 0.5));  // hard spheres as large as the cutoff
}
