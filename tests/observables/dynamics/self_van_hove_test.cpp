#include "observables/dynamics/self_van_hove.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "ideal_gas.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("displacements of an ideal gas are normal") {
    constexpr Index atoms = 100;
    SelfVanHove displacements(atoms, {1, 8, 0.1}, 1, {4.0, 40, 2});
    sample_ideal_gas(displacements, atoms, 8.0, 400, 9, 0.1);
    const auto tables = displacements.tables();
    REQUIRE(tables.size() == 2);
    REQUIRE(tables[0].rows.size() == 8);
    for (const auto& row : tables[0].rows) {
        CHECK(std::abs(row[1]) < 5.0 * row[2]);
        CHECK(row[2] < 0.01);
    }
    REQUIRE(tables[1].rows.size() == 80);
    double integral = 0.0;
    for (const auto& row : tables[1].rows) {
        const double variance = row[0] * row[0] * (1.0 - 1.0 / atoms);
        const double r = row[1];
        integral += row[0] > 0.5
                        ? 0.0
                        : row[2] * 4.0 / 3.0 * std::numbers::pi * (std::pow(r + 0.05, 3) - std::pow(r - 0.05, 3));
        if (r * r > 9.0 * variance) {
            continue;  // no atom went so far
        }
        // The mean of the normal distribution over the shell.
        const auto below = [&](double x) {
            const double s = x / std::sqrt(variance);
            return std::erf(s / std::sqrt(2.0)) - std::sqrt(2.0 / std::numbers::pi) * s * std::exp(-0.5 * s * s);
        };
        const double volume = 4.0 / 3.0 * std::numbers::pi * (std::pow(r + 0.05, 3) - std::pow(r - 0.05, 3));
        const double wanted = (below(r + 0.05) - below(r - 0.05)) / volume;
        CHECK(std::abs(row[2] - wanted) < 5.0 * row[3] + 1e-3 * wanted);
    }
    CHECK(integral == Approx(1.0));
}

TEST_CASE("alpha_2 is the moments' ratio, with time origins that overlap") {
    // Two atoms: the first moves by t^2 along x, the second by -t^2; about their centre.
    SelfVanHove displacements(2, {1, 3, 1.0}, 3, {10.0, 10, 1});
    for (Index frame = 0; frame < 9; ++frame) {
        State state(2, Box(Vec3(50.0, 50.0, 50.0)));
        const double way = 0.1 * static_cast<double>(frame * frame);
        state.write_positions().col(0) = Vec3(10.0 + way, 1.0, 2.0);
        state.write_positions().col(1) = Vec3(20.0 - way, 1.0, 2.0);
        displacements.sample(state, Evaluation{});
    }
    const auto tables = displacements.tables();
    for (std::size_t lag = 1; lag <= 3; ++lag) {
        double squares = 0.0;
        double fourths = 0.0;
        for (std::size_t first = 0; first < 6; ++first) {
            const double way = 0.1 * static_cast<double>((first + lag) * (first + lag) - first * first);
            squares += way * way / 6.0;
            fourths += way * way * way * way / 6.0;
        }
        CHECK(tables[0].rows[lag - 1][0] == Approx(static_cast<double>(lag)));
        CHECK(tables[0].rows[lag - 1][1] == Approx(0.6 * fourths / (squares * squares) - 1.0));
    }
}

TEST_CASE("displacements at more times than there are, or up to nothing, are refused") {
    CHECK_THROWS_AS(SelfVanHove(2, {1, 3, 1.0}, 3, {10.0, 10, 4}), ContractViolation);
    CHECK_THROWS_AS(SelfVanHove(2, {1, 3, 1.0}, 3, {0.0, 10, 1}), ContractViolation);
}
