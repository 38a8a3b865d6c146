#include "ljmd/detail/reference/freezing.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("the full Lennard-Jones fluid freezes, and its crystal melts, where Mastny and de Pablo found") {
    const auto argon = freezing_densities(0.722);
    REQUIRE(argon);
    CHECK(argon->freezing == Approx(0.8545).margin(5e-5));
    CHECK(argon->melting == Approx(0.9648).margin(5e-5));
    const auto one = freezing_densities(1.0);  // the sums of the coefficients
    CHECK(one->freezing == Approx(0.91857).epsilon(1e-14));
    CHECK(one->melting == Approx(1.006283).epsilon(1e-14));
}

TEST_CASE("there is freezing from the triple point to the highest temperature, and nothing is said beyond") {
    CHECK(freezing_densities(triple_point_temperature));
    CHECK(freezing_densities(highest_freezing_temperature));
    CHECK_FALSE(freezing_densities(0.6939));
    CHECK_FALSE(freezing_densities(5.001));
    CHECK_FALSE(freezing_densities(0.0));
    CHECK_FALSE(freezing_densities(std::numeric_limits<double>::quiet_NaN()));
}

TEST_CASE(
    "the densities grow with temperature, the crystal is the denser one, and the way to high temperatures is kept") {
    // T = A rho^4 + B rho^2 through the triple point and the limit of repulsion alone, rho = 0.813 T^(1/4).
    const double a = std::pow(0.813, -4.0);
    const double least2 = std::pow(freezing_densities(triple_point_temperature)->freezing, 2.0);
    const double b = (triple_point_temperature - a * least2 * least2) / least2;
    FreezingDensities last{0.0, 0.0};
    for (double t = triple_point_temperature; t <= highest_freezing_temperature; t += 0.05) {
        INFO(t);
        const FreezingDensities now = *freezing_densities(t);
        CHECK(now.freezing > last.freezing);
        CHECK(now.melting > last.melting);
        CHECK(now.melting > 1.035 * now.freezing);
        const double simple = std::sqrt((-b + std::sqrt(b * b + 4.0 * a * t)) / (2.0 * a));
        CHECK(now.freezing == Approx(simple).epsilon(0.035));
        last = now;
    }
}
