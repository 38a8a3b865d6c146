#include "core/quadrature.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

using std::numbers::pi;
constexpr double everywhere = std::numeric_limits<double>::infinity();

Approx within(double value) {
    return Approx(value).epsilon(1e-12).margin(1e-15);
}

}  // namespace

TEST_CASE("finite integrals agree with their closed forms") {
    CHECK(integrate([](double x) { return x * x * x; }, 0.0, 2.0) == within(4.0));
    CHECK(integrate([](double x) { return std::sin(x); }, 0.0, pi) == within(2.0));
    CHECK(integrate([](double x) { return 1.0 / (1.0 + x * x); }, -1.0, 1.0) == within(pi / 2.0));
    CHECK(integrate([](double x) { return std::cos(100.0 * x); }, 0.0, 1.0) == within(std::sin(100.0) / 100.0));
    CHECK(integrate([](double x) { return std::exp(-x); }, -20.0, 0.0) == within(std::exp(20.0) - 1.0));
    CHECK(integrate([](double x) { return x < 0.3 ? 1.0 : 0.0; }, 0.0, 1.0) == Approx(0.3).epsilon(1e-11));
}

TEST_CASE("infinite integrals agree with their closed forms") {
    CHECK(integrate([](double x) { return std::exp(-x * x); }, 0.0, everywhere) == within(std::sqrt(pi) / 2.0));
    CHECK(integrate([](double x) { return std::exp(-x); }, 3.0, everywhere) == within(std::exp(-3.0)));
    CHECK(integrate([](double x) { return 1.0 / (x * x); }, 0.5, everywhere) == within(2.0));
    CHECK(integrate([](double x) { return std::pow(x, -10); }, 2.5, everywhere) == within(std::pow(2.5, -9) / 9.0));
    CHECK(integrate([](double x) { return 1e-20 * std::exp(-x); }, 0.0, everywhere) == Approx(0.0).margin(1e-15));
}

TEST_CASE("bounds: an empty interval gives zero, exchanged bounds change the sign") {
    const auto square = [](double x) { return x * x; };
    CHECK(integrate(square, 1.5, 1.5) == 0.0);
    CHECK(integrate(square, 2.0, 1.0) == within(-7.0 / 3.0));
}

TEST_CASE("an integrable end point and cancelling halves are no error") {
    CHECK(integrate([](double x) { return std::log(x); }, 0.0, 1.0) == Approx(-1.0).epsilon(1e-11));
    CHECK(integrate([](double x) { return std::sin(x); }, 0.0, 2.0 * pi) == Approx(0.0).margin(1e-12));
    CHECK(integrate([](double x) { return x * x * x; }, -1.0, 1.0) == Approx(0.0).margin(1e-15));
}

TEST_CASE("an integral that does not converge is an error that says so") {
    CHECK_THROWS_AS(integrate([](double x) { return 1.0 / x; }, 0.0, 1.0), PhysicsError);
    CHECK_THROWS_AS(integrate([](double x) { return 1.0 / x; }, 1.0, everywhere), PhysicsError);
    CHECK_THROWS_AS(integrate([](double) { return 1.0; }, 0.0, everywhere), PhysicsError);
    // GSL calls these two mere round-off.
    CHECK_THROWS_AS(integrate([](double x) { return std::sin(x); }, 0.0, everywhere), PhysicsError);
    CHECK_THROWS_AS(integrate([](double x) { return std::cos(x); }, 0.0, everywhere), PhysicsError);
    CHECK_THROWS_AS(integrate([](double x) { return 1.0 / (x - 0.5); }, 0.0, 1.0), PhysicsError);
    CHECK_THROWS_AS(integrate([](double) { return std::nan(""); }, 0.0, 1.0), PhysicsError);
    CHECK_THROWS_AS(integrate([](double) { return std::nan(""); }, 0.0, everywhere), PhysicsError);
    CHECK_THROWS_WITH(integrate([](double x) { return 1.0 / x; }, 0.25, everywhere),
                      Catch::StartsWith("an integral from 0.25 to inf does not converge: "));
}
