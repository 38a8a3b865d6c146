#include "observables/few_body/polar_angle.hpp"

#include <cmath>
#include "catch.hpp"

using namespace ljmd;

namespace {

/// The angle at t = 2 where its rate is 1 + cos(t), from so many steps, of two lengths in turn; exact: 2 + sin(2).
double angle_at_two(int steps) {
    PolarAngleQuadrature quadrature;
    PolarAngle angle{};
    for (int n = 0; n <= steps; ++n) {
        const double t = 2.0 / steps * (n + (n % 2 == 0 ? 0.0 : 0.5));
        angle = quadrature.add(t, 1.0 + std::cos(t), -std::sin(t));
    }
    return angle.value;
}

}  // namespace

TEST_CASE("a polar angle begins at zero, whenever that is") {
    PolarAngleQuadrature quadrature;
    const PolarAngle first = quadrature.add(5.0, 3.0, -2.0);
    CHECK(first.value == 0.0);
    CHECK(first.rate == 3.0);
    const PolarAngle second = quadrature.add(5.5, 1.0, -5.0);
    CHECK(second.value == Approx(1.0 + 0.0625).epsilon(1e-15));  // 0.25 (3 + 1) + 0.25/12 (-2 + 5)
    CHECK(second.rate == 1.0);
}

TEST_CASE("a polar angle is the integral of its rate to fourth order, whatever the lengths of the steps") {
    const double exact = 2.0 + std::sin(2.0);
    const double coarse = angle_at_two(100) - exact;
    const double fine = angle_at_two(200) - exact;
    CHECK(std::abs(coarse) < 1e-8);
    CHECK(coarse / fine == Approx(16.0).epsilon(1e-2));
}

TEST_CASE("a second rate at the same time replaces the first and turns nothing") {
    PolarAngleQuadrature quadrature;
    quadrature.add(0.0, 1.0, 0.0);
    quadrature.add(1.0, 1.0, 0.0);
    CHECK(quadrature.add(1.0, -1.0, 0.0).value == 1.0);
    CHECK(quadrature.add(2.0, -1.0, 0.0).value == 0.0);
}
