#include "ljmd/detail/core/elementary.hpp"

#include <xxhash.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <vector>
#include "catch.hpp"

using namespace ljmd;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Distance of a value from the right one, in units in the last place of a double.
double ulps(double value, long double right) {
    if (std::isinf(static_cast<double>(right)) || right == 0.0L) {
        return value == static_cast<double>(right) ? 0.0 : infinite;
    }
    int exponent = 0;
    std::frexp(static_cast<double>(right), &exponent);
    return static_cast<double>(std::abs(value - right) / std::ldexp(1.0L, std::max(exponent - 53, -1074)));
}

/// Numbers in [0, 1) that are the same with every library.
class Uniform {
  public:
    double operator()() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
    double operator()(double from, double to) { return from + (to - from) * (*this)(); }
    /// With any exponent and sign.
    double any(int least, int most) {
        const double size = std::ldexp(1.0 + (*this)(), static_cast<int>((*this)(least, most)));
        return (*this)() < 0.5 ? -size : size;
    }

  private:
    std::mt19937_64 engine_{1967};
};

/// The largest distance over many arguments. That of the C library in extended precision is right to a thousandth of a
/// unit in the last place of a double.
template <class Function, class Right, class Argument>
double worst(const Function& function, const Right& right, const Argument& argument) {
    double found = 0.0;
    for (int k = 0; k < 200'000; ++k) {
        const double x = argument();
        found = std::max(found, ulps(function(x), right(static_cast<long double>(x))));
    }
    return found;
}

template <class Function>
std::uint64_t hash_of(const Function& function, double from, double to) {
    Uniform uniform;
    std::vector<double> values;
    for (int k = 0; k < 100'000; ++k) {
        values.push_back(function(uniform(from, to)));
    }
    return XXH3_64bits(values.data(), values.size() * sizeof(double));
}

}  // namespace

TEST_CASE("elementary functions are right within one unit in the last place") {
    Uniform u;
    const auto log = [](long double x) { return std::log(x); };
    CHECK(worst(logarithm, log, [&] { return 1.0 - u(); }) <= 1.0);
    CHECK(worst(logarithm, log, [&] { return std::abs(u.any(-1060, 1020)); }) <= 1.0);
    CHECK(worst(logarithm, log, [&] { return u(0.9, 1.1); }) <= 1.0);
    const auto exp = [](long double x) { return std::exp(x); };
    CHECK(worst(exponential, exp, [&] { return u(-1.0, 1.0); }) <= 1.0);
    CHECK(worst(exponential, exp, [&] { return u(-745.0, 709.7); }) <= 1.0);
    const auto expm1 = [](long double x) { return std::expm1(x); };
    const auto less_one = [](double x) { return exponential_minus_one(x); };
    CHECK(worst(less_one, expm1, [&] { return u(-1.0, 1.0); }) <= 1.0);
    CHECK(worst(less_one, expm1, [&] { return u.any(-80, 5); }) <= 1.0);
    CHECK(worst(less_one, expm1, [&] { return u(-45.0, 709.7); }) <= 1.0);
    const auto cbrt = [](long double x) { return std::cbrt(x); };
    CHECK(worst(cube_root, cbrt, [&] { return u.any(-1060, 1020); }) <= 1.0);
    const auto sin = [](long double x) { return std::sin(x); };
    CHECK(worst(sine, sin, [&] { return u(-10.0, 10.0); }) <= 1.0);
    CHECK(worst(sine, sin, [&] { return u.any(-1000, 40); }) <= 1.0);
    // A turn is reduced exactly to an eighth of one. For that much extended precision has enough digits.
    constexpr long double circle = 2.0L * std::numbers::pi_v<long double>;
    const auto small = [&] { return u(-0.125, 0.125); };
    CHECK(worst([](double t) { return of_turns(t).sine; }, [](long double t) { return std::sin(circle * t); }, small) <=
          1.0);
    CHECK(worst([](double t) { return of_turns(t).cosine; }, [](long double t) { return std::cos(circle * t); },
                small) <= 1.0);
}

TEST_CASE("elementary functions have the same bits on every machine") {
    CHECK(hash_of(logarithm, 0.0, 1.0) == 0x6de647e88e5d78a2);
    CHECK(hash_of(exponential, -50.0, 50.0) == 0x88029836ea8184b4);
    CHECK(hash_of([](double x) { return exponential_minus_one(x); }, -3.0, 3.0) == 0x6936805b917e28a4);
    CHECK(hash_of(cube_root, 0.0, 1e4) == 0x33641254408d862);
    CHECK(hash_of(sine, -1e4, 1e4) == 0xa1e880a70ddad987);
    CHECK(hash_of([](double t) { return of_turns(t).sine + 3.0 * of_turns(t).cosine; }, 0.0, 1.0) ==
          0xe8aece03c95124e1);
}

TEST_CASE("elementary functions know their special values") {
    CHECK(logarithm(1.0) == 0.0);
    CHECK(logarithm(0.0) == -infinite);
    CHECK(logarithm(infinite) == infinite);
    CHECK(std::isnan(logarithm(-1.0)));
    CHECK(exponential(0.0) == 1.0);
    CHECK(exponential(-infinite) == 0.0);
    CHECK(exponential(800.0) == infinite);
    CHECK(std::isnan(exponential(std::nan(""))));
    CHECK(exponential_minus_one(-infinite) == -1.0);
    CHECK(exponential_minus_one(infinite) == infinite);
    CHECK(exponential_minus_one(1e-300) == 1e-300);
    CHECK(std::isnan(exponential_minus_one(std::nan(""))));
    CHECK(cube_root(-27.0) == -3.0);
    CHECK(cube_root(1000.0) == 10.0);
    CHECK(cube_root(0.0) == 0.0);
    CHECK(cube_root(infinite) == infinite);
    CHECK(sine(0.0) == 0.0);
    CHECK(std::isnan(sine(infinite)));
    for (int quarter = -8; quarter <= 8; ++quarter) {
        const auto [s, c] = of_turns(0.25 * quarter);
        CHECK(s == std::round(std::sin(0.5 * std::numbers::pi * quarter)));
        CHECK(c == std::round(std::cos(0.5 * std::numbers::pi * quarter)));
    }
}

TEST_CASE("elementary functions rise where they should") {
    Uniform u;
    int falls = 0;
    for (int k = 0; k < 200'000; ++k) {
        const double x = u();
        const double y = u(-20.0, 20.0);
        falls += logarithm(std::nextafter(x, 2.0)) < logarithm(x) ? 1 : 0;
        falls += cube_root(std::nextafter(x, 2.0)) < cube_root(x) ? 1 : 0;
        falls += exponential(std::nextafter(y, 30.0)) < exponential(y) ? 1 : 0;
        falls += exponential_minus_one(std::nextafter(y, 30.0)) < exponential_minus_one(y) ? 1 : 0;
    }
    CHECK(falls == 0);
}
