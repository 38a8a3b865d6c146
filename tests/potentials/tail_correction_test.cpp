#include "ljmd/detail/potentials/tail_correction.hpp"

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>
#include "catch.hpp"

#include "potentials/made_potential.hpp"

using namespace ljmd;
using test::made_potential;

namespace {

using std::numbers::pi;

/// Simpson's rule, as a second opinion on the quadrature.
double simpson(const std::function<double(double)>& f, double a, double b) {
    constexpr int halves = 4000;
    const double h = (b - a) / (2 * halves);
    double sum = f(a) + f(b);
    for (int k = 1; k < 2 * halves; ++k) {
        sum += (k % 2 == 1 ? 4.0 : 2.0) * f(a + k * h);
    }
    return sum * h / 3.0;
}

/// Morse beyond R in closed form. With e_n = exp(-n a (R - r0)), b = n a and repeated integration by parts,
///     integral of exp(-b (r - r0)) r^2 = e_n (R^2/b + 2 R/b^2 + 2/b^3),
///     integral of exp(-b (r - r0)) r^3 = e_n (R^3/b + 3 R^2/b^2 + 6 R/b^3 + 6/b^4).
TailIntegrals morse_tail(double depth, double steepness, double minimum, double radius) {
    const auto e = [=](double n) { return std::exp(-n * steepness * (radius - minimum)); };
    const auto square = [=](double n) {
        const double b = n * steepness;
        return e(n) * (std::pow(radius, 2) / b + 2.0 * radius / std::pow(b, 2) + 2.0 / std::pow(b, 3));
    };
    const auto cube = [=](double n) {
        const double b = n * steepness;
        return e(n) * (std::pow(radius, 3) / b + 3.0 * std::pow(radius, 2) / std::pow(b, 2) +
                       6.0 * radius / std::pow(b, 3) + 6.0 / std::pow(b, 4));
    };
    return {depth * (square(2.0) - 2.0 * square(1.0)), 2.0 * depth * steepness * (cube(2.0) - cube(1.0))};
}

void check_equal(const TailIntegrals& found, const TailIntegrals& expected, double tolerance) {
    CHECK(found.energy == Approx(expected.energy).epsilon(tolerance));
    CHECK(found.virial == Approx(expected.virial).epsilon(tolerance));
}

}  // namespace

TEST_CASE("the tail of cut Lennard-Jones is Verlet's, and quadrature finds the same") {
    for (const double rc : {1.5, 2.5, 3.0, 4.0, 6.0}) {
        const auto potential = PairPotential::lennard_jones("cut", {rc, 0.0});
        const TailCorrection tail(potential);
        const double r3 = std::pow(rc, -3);
        const double r9 = std::pow(rc, -9);
        CAPTURE(rc);
        for (const double rho : {0.01, 0.35, 0.8442}) {
            CHECK(tail.energy(rho) == Approx(8.0 / 3.0 * pi * rho * (r9 / 3.0 - r3)).epsilon(1e-14));
            CHECK(tail.pressure(rho) == Approx(16.0 / 3.0 * pi * rho * rho * (2.0 * r9 / 3.0 - r3)).epsilon(1e-14));
        }
        check_equal(potential.tail_by_quadrature(), potential.tail(), 1e-11);
    }
}

TEST_CASE("tails of NIST's reference configurations to the printed digits") {
    std::ifstream file(LJMD_TEST_DATA "/nist/published.csv");
    int rows = 0;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#' || line[0] == 'c') {
            continue;
        }
        for (char& c : line) {
            c = c == ',' ? ' ' : c;
        }
        std::istringstream fields(line);
        double config = 0.0, atoms = 0.0, edge = 0.0, rc = 0.0, energy = 0.0, virial = 0.0, published = 0.0;
        REQUIRE(fields >> config >> atoms >> edge >> rc >> energy >> virial >> published);
        const TailCorrection tail(PairPotential::lennard_jones("cut", {rc, 0.0}));
        const double found = atoms * tail.energy(atoms / std::pow(edge, 3));
        const double last_digit = std::pow(10.0, std::floor(std::log10(std::abs(published))) - 4.0);
        CAPTURE(config, rc, found, published);
        CHECK(std::abs(found - published) <= 0.5001 * last_digit);
        ++rows;
    }
    CHECK(rows == 8);
}

TEST_CASE("the tail of a formula without a closed form of its own comes from quadrature") {
    for (const double rc : {1.5, 2.0, 2.5}) {
        CAPTURE(rc);
        const auto by_default = made_potential("morse", "cut", {rc, 0.0});
        check_equal(by_default.tail(), morse_tail(1.0, 6.0, 1.122462048309373, rc), 1e-11);
        const auto soft =
            made_potential("morse", "cut", {rc, 0.0}, {{"well_depth", 2.5}, {"steepness", 1.7}, {"minimum", 1.3}});
        check_equal(soft.tail(), morse_tail(2.5, 1.7, 1.3, rc), 1e-11);
    }
}

TEST_CASE("a switched potential misses the cut one's tail and what the switch takes away, for every formula") {
    for (const std::string& formula : PairPotential::formula_names()) {
        for (const Cutoff& cutoff : {Cutoff{2.5, 2.0}, Cutoff{3.0, 1.4}, Cutoff{2.5, 2.49}}) {
            CAPTURE(formula, cutoff.radius, cutoff.switch_start);
            const auto cut = made_potential(formula, "cut", cutoff);
            const auto switched = made_potential(formula, "switched", cutoff);
            const auto u_missing = [&](double r) { return (cut.untruncated(r).u - switched(r).u) * r * r; };
            const auto w_missing = [&](double r) { return (cut.untruncated(r).w - switched(r).w) * r * r * r * r; };
            const TailIntegrals expected = {cut.tail().energy + simpson(u_missing, cutoff.switch_start, cutoff.radius),
                                            cut.tail().virial + simpson(w_missing, cutoff.switch_start, cutoff.radius)};
            check_equal(switched.tail(), expected, 1e-10);
            check_equal(switched.tail_by_quadrature(), expected, 1e-10);
            CHECK(std::abs(switched.tail().energy) > std::abs(cut.tail().energy));
        }
    }
}

TEST_CASE("energy and pressure tails are tied by an integration by parts") {
    // From w r = -u' by parts: integral of w r^4 = R^3 u(R) + 3 * integral of u r^2. For a switched potential the
    // boundary terms of what is missing vanish at its start and cancel at rc, for every formula.
    for (const std::string& formula : PairPotential::formula_names()) {
        const auto cut = made_potential(formula, "cut", {2.5, 0.0});
        CAPTURE(formula);
        const double flux = std::pow(2.5, 3) * cut.untruncated(2.5).u;
        CHECK(cut.tail().virial == Approx(flux + 3.0 * cut.tail().energy).epsilon(1e-11));
        const auto switched = made_potential(formula, "switched", {2.5, 1.9}).tail();
        CHECK(switched.virial == Approx(3.0 * switched.energy).epsilon(1e-11));
    }
}

TEST_CASE("shifted forms: the integrals are those beyond the cutoff") {
    for (const std::string truncation : {"shifted", "force-shifted"}) {
        const auto shifted = PairPotential::lennard_jones(truncation, {2.5, 0.0}).tail();
        const auto cut = PairPotential::lennard_jones("cut", {2.5, 0.0}).tail();
        CHECK(shifted.energy == cut.energy);
        CHECK(shifted.virial == cut.virial);
    }
}

TEST_CASE("corrections grow with the density as u ~ rho and p ~ rho^2") {
    const TailCorrection tail(PairPotential::lennard_jones("cut", {2.5, 0.0}));
    CHECK(tail.energy(0.8) == Approx(2.0 * tail.energy(0.4)).epsilon(1e-15));
    CHECK(tail.pressure(0.8) == Approx(4.0 * tail.pressure(0.4)).epsilon(1e-15));
    CHECK(tail.energy(0.0) == 0.0);
    CHECK(tail.pressure(0.0) == 0.0);
}

TEST_CASE("without a potential there is no correction") {
    CHECK(TailCorrection().energy(0.8442) == 0.0);
    CHECK(TailCorrection().pressure(0.8442) == 0.0);
}
