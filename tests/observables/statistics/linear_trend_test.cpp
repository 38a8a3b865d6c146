#include "observables/statistics/linear_trend.hpp"

#include <cmath>
#include <limits>
#include <random>
#include "catch.hpp"

using ljmd::Archive;
using ljmd::CheckpointError;
using ljmd::Index;
using ljmd::LinearTrend;

TEST_CASE("The slope of points on a line is exact") {
    LinearTrend trend;
    for (int i = 0; i < 1000; ++i) {
        trend.add(0.5 * i, 3.0 - 2.0 * (0.5 * i));
    }
    CHECK(trend.samples() == 1000);
    REQUIRE(trend.slope().has_value());
    CHECK(*trend.slope() == Approx(-2.0).epsilon(1e-13));
}

TEST_CASE("The slope of scattered points is the least-squares one") {
    LinearTrend trend;
    trend.add(0.0, 1.0);
    trend.add(1.0, 0.0);
    trend.add(2.0, 5.0);
    trend.add(4.0, 2.0);
    // By hand: <t> = 7/4, <y> = 2; sum of products 4, sum of squares 35/4.
    CHECK(*trend.slope() == Approx(4.0 / 8.75).epsilon(1e-15));
}

TEST_CASE("A flat series has slope zero") {
    LinearTrend trend;
    for (int i = 0; i < 10; ++i) {
        trend.add(i, -4.625);
    }
    CHECK(*trend.slope() == 0.0);
}

TEST_CASE("A small drift survives large offsets of time and energy") {
    std::mt19937_64 generator(1);
    std::normal_distribution<double> normal;
    const double time_offset = 1e6;
    const double energy_offset = 1e6;
    const double drift = 1e-5;
    LinearTrend trend;
    const int samples = 100000;
    for (int i = 0; i < samples; ++i) {
        const double t = 0.01 * i;
        trend.add(time_offset + t, energy_offset + drift * t + 1e-5 * normal(generator));
    }
    // Standard error of the slope: 1e-5 / (n^(1/2) 1000 / 12^(1/2)) = 1.1e-10.
    CHECK(std::abs(*trend.slope() - drift) < 5e-10);
}

TEST_CASE("No slope without two different times") {
    LinearTrend trend;
    CHECK_FALSE(trend.slope().has_value());
    trend.add(0.1, 5.0);
    CHECK_FALSE(trend.slope().has_value());
    trend.add(0.1, 6.0);
    trend.add(0.1, 7.0);
    CHECK_FALSE(trend.slope().has_value());
    trend.add(0.2, 8.0);
    CHECK(trend.slope().has_value());
}

TEST_CASE("a trend of a number of points that cannot be is not taken from an archive") {
    for (Index points : {Index{-1}, std::numeric_limits<Index>::max()}) {
        Archive a;
        double zero = 0.0;
        a(points, zero, zero, zero, zero);
        Archive back(a.bytes());
        LinearTrend trend;
        CHECK_THROWS_AS(trend.archive(back), CheckpointError);
    }
}
