#include "core/roots.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("roots are found to the last digits, from either order of the ends") {
    CHECK(find_root([](double x) { return std::cos(x); }, 0.0, 3.0) == Approx(std::numbers::pi / 2.0).epsilon(1e-15));
    CHECK(find_root([](double x) { return x * x - 2.0; }, 5.0, 0.0) == Approx(std::numbers::sqrt2).epsilon(1e-15));
    CHECK(find_root([](double x) { return x + x * x * x; }, -1.0, 2.0) == Approx(0.0).margin(1e-15));
    CHECK(find_root([](double x) { return std::expm1(x) - 1e-9; }, -1.0, 1.0) == Approx(1e-9).epsilon(1e-6));
}

TEST_CASE("a root at an end is found") {
    CHECK(find_root([](double x) { return x - 1.0; }, 1.0, 2.0) == Approx(1.0));
    CHECK(find_root([](double x) { return x - 2.0; }, 1.0, 2.0) == Approx(2.0));
}

TEST_CASE("ends of one sign, and what is not finite, are refused") {
    CHECK_THROWS_AS(find_root([](double x) { return x * x + 1.0; }, -1.0, 1.0), PhysicsError);
    CHECK_THROWS_AS(find_root([](double) { return std::nan(""); }, -1.0, 1.0), PhysicsError);
}

TEST_CASE("an error of the function comes out as it was thrown") {
    CHECK_THROWS_AS(find_root([](double) -> double { throw InputError("no"); }, -1.0, 1.0), InputError);
}
