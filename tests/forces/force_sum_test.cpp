#include "forces/force_sum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>
#include "catch.hpp"

using namespace ljmd;

namespace {

template <class Sum>
double sum_of(const std::vector<double>& terms) {
    Sum sum;
    for (const double term : terms) {
        sum.add(term);
    }
    return sum.value();
}

std::vector<double> sample() {
    std::vector<double> terms;
    for (int k = 1; k <= 60; ++k) {
        terms.push_back(700.0 * std::sin(3.0 * k) * std::exp(-0.1 * k));
    }
    return terms;
}

}  // namespace

TEST_CASE("a fixed-point sum is the same to the last bit in any order, a floating one is not") {
    std::vector<double> terms = sample();
    const double fixed = sum_of<FixedPointSum>(terms);
    const double floating = sum_of<FloatingSum>(terms);
    bool differs = false;
    std::sort(terms.begin(), terms.end());
    for (int k = 0; k < 20; ++k) {
        std::rotate(terms.begin(), terms.begin() + 7, terms.end());
        CHECK(sum_of<FixedPointSum>(terms) == fixed);
        differs = differs || sum_of<FloatingSum>(terms) != floating;
    }
    CHECK(differs);
    CHECK(fixed == Approx(floating).margin(60 * 0x1p-45));
}

TEST_CASE("a fixed-point sum is odd: terms of opposite sign cancel to the last bit") {
    std::vector<double> terms = sample();
    const double sum = sum_of<FixedPointSum>(terms);
    for (double& term : terms) {
        term = -term;
    }
    CHECK(sum_of<FixedPointSum>(terms) == -sum);
}

TEST_CASE("a fixed-point sum rounds each term to the nearest multiple of 2^-44") {
    CHECK(sum_of<FixedPointSum>({0x1p-46}) == 0.0);
    CHECK(sum_of<FixedPointSum>({0x1.8p-45}) == 0x1p-44);
    CHECK(sum_of<FixedPointSum>({-0x1.8p-45}) == -0x1p-44);
    CHECK(sum_of<FixedPointSum>({1.0, -0.25}) == 0.75);
}

TEST_CASE("what fixed-point sums cannot hold is refused, not wrapped round") {
    CHECK_THROWS_AS(sum_of<FixedPointSum>({0x1p18}), PhysicsError);
    CHECK_THROWS_AS(sum_of<FixedPointSum>({1e300, -1e300}), PhysicsError);
    CHECK_THROWS_AS(sum_of<FixedPointSum>({std::numeric_limits<double>::quiet_NaN()}), PhysicsError);
    CHECK_THROWS_AS(sum_of<FixedPointSum>(std::vector<double>(5, 60000.0)), PhysicsError);
    CHECK(sum_of<FixedPointSum>({80000.0, 80000.0, -80000.0}) == 80000.0);
}
