#include "observables/statistics/hermite.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/types.hpp"

using namespace ljmd;

TEST_CASE("A cubic and its rate are interpolated exactly") {
    const auto x = [](double t) { return 2.0 - t + 3.0 * t * t - 0.5 * t * t * t; };
    const auto v = [](double t) { return -1.0 + 6.0 * t - 1.5 * t * t; };
    const HermiteStep<double> step{1.5, 0.7, x(1.5), v(1.5), x(2.2), v(2.2)};
    for (const double s : {0.0, 0.1, 0.5, 0.83, 1.0}) {
        CAPTURE(s);
        const double t = step.time(s);
        CHECK(t == Approx(1.5 + 0.7 * s).epsilon(1e-15));
        CHECK(step.value(s) == Approx(x(t)).epsilon(1e-14));
        CHECK(step.rate(s) == Approx(v(t)).epsilon(1e-14));
    }
}

TEST_CASE("The error of the interpolated value is of fourth order with the constant 1/384, for vectors too") {
    const auto r = [](double t) { return Vec3(std::cos(t), std::sin(t), t); };
    const auto v = [](double t) { return Vec3(-std::sin(t), std::cos(t), 1.0); };
    for (const double h : {0.2, 0.1, 0.05}) {
        CAPTURE(h);
        const HermiteStep<Vec3> step{0.3, h, r(0.3), v(0.3), r(0.3 + h), v(0.3 + h)};
        const double error = (step.value(0.5) - r(0.3 + 0.5 * h)).norm();
        CHECK(error * 384.0 / std::pow(h, 4) == Approx(1.0).epsilon(0.01));
    }
}

TEST_CASE("A change of sign in a step is found to the last digits, wherever it lies") {
    for (const double root : {1e-12, 0.1, 0.5, 0.9999}) {
        CHECK(root_in_step([&](double s) { return s - root; }) == Approx(root).epsilon(1e-5).margin(2e-16));
        CHECK(root_in_step([&](double s) { return std::expm1(root - s); }) == Approx(root).margin(2e-16));
    }
    CHECK(root_in_step([](double s) { return s * s - 0.5; }) == Approx(std::sqrt(0.5)).epsilon(1e-15));
}
