#include "ljmd/detail/core/taylor.hpp"

#include <cmath>
#include <vector>
#include "catch.hpp"

using namespace ljmd;

namespace {

constexpr double at_x = 0.7;
constexpr double at_y = 1.3;
const Taylor x = Taylor::x(at_x);
const Taylor y = Taylor::y(at_y);

Approx close(double value) {
    return Approx(value).epsilon(1e-14).margin(1e-14);
}

}  // namespace

TEST_CASE("a constant has no derivatives, a variable one") {
    for (std::size_t i = 0; i <= 3; ++i) {
        for (std::size_t j = 0; i + j <= 3; ++j) {
            CHECK(Taylor(5.0).derivative(i, j) == (i + j == 0 ? 5.0 : 0.0));
            CHECK(x.derivative(i, j) == (i + j == 0 ? at_x : i == 1 && j == 0 ? 1.0 : 0.0));
            CHECK(y.derivative(i, j) == (i + j == 0 ? at_y : i == 0 && j == 1 ? 1.0 : 0.0));
        }
    }
}

TEST_CASE("a polynomial has its own derivatives, mixed ones too") {
    const Taylor f = 2.0 * x * x * y - y * y * y + 3.0 * x - 1.0;
    CHECK(f.value() == close(2.0 * at_x * at_x * at_y - at_y * at_y * at_y + 3.0 * at_x - 1.0));
    CHECK(f.derivative(1, 0) == close(4.0 * at_x * at_y + 3.0));
    CHECK(f.derivative(0, 1) == close(2.0 * at_x * at_x - 3.0 * at_y * at_y));
    CHECK(f.derivative(2, 0) == close(4.0 * at_y));
    CHECK(f.derivative(1, 1) == close(4.0 * at_x));
    CHECK(f.derivative(0, 2) == close(-6.0 * at_y));
    CHECK(f.derivative(2, 1) == close(4.0));
    CHECK(f.derivative(1, 2) == close(0.0));
    CHECK(f.derivative(0, 3) == close(-6.0));
    CHECK(f.derivative(3, 0) == close(0.0));
}

TEST_CASE("functions of one variable: their closed-form derivatives") {
    const auto check = [](const Taylor& f, const std::vector<double>& derivatives) {
        for (std::size_t i = 0; i <= 3; ++i) {
            CHECK(f.derivative(i, 0) == close(derivatives[i]));
            CHECK((i == 0 || f.derivative(0, i) == 0.0));
        }
    };
    const double e = std::exp(at_x);
    check(exp(x), {e, e, e, e});
    check(log1p(x - 1.0), {std::log(at_x), 1.0 / at_x, -std::pow(at_x, -2), 2.0 * std::pow(at_x, -3)});
    CHECK(log1p(1e-20 * x).value() == 1e-20 * at_x);
    check(log(x), {std::log(at_x), 1.0 / at_x, -std::pow(at_x, -2), 2.0 * std::pow(at_x, -3)});
    check(1.0 / x, {1.0 / at_x, -std::pow(at_x, -2), 2.0 * std::pow(at_x, -3), -6.0 * std::pow(at_x, -4)});
    check(pow(x, 2.5),
          {std::pow(at_x, 2.5), 2.5 * std::pow(at_x, 1.5), 3.75 * std::pow(at_x, 0.5), 1.875 * std::pow(at_x, -0.5)});
    check(pow(x, -1.5), {std::pow(at_x, -1.5), -1.5 * std::pow(at_x, -2.5), 3.75 * std::pow(at_x, -3.5),
                         -13.125 * std::pow(at_x, -4.5)});
    check(pow(x, 2), {at_x * at_x, 2.0 * at_x, 2.0, 0.0});
    check(pow(x, 0), {1.0, 0.0, 0.0, 0.0});
}

TEST_CASE("composition: functions of both variables") {
    const Taylor f = exp(x * y);
    const double e = std::exp(at_x * at_y);
    CHECK(f.derivative(1, 1) == close(e * (1.0 + at_x * at_y)));
    CHECK(f.derivative(2, 1) == close(e * (2.0 * at_y + at_x * at_y * at_y)));
    CHECK(f.derivative(0, 3) == close(e * at_x * at_x * at_x));
    const Taylor same = log(exp(x) * exp(-y)) - (x - y);
    const Taylor one = (x * y + 2.0) / (x * y + 2.0);
    for (std::size_t i = 0; i <= 3; ++i) {
        for (std::size_t j = 0; i + j <= 3; ++j) {
            CHECK(same.derivative(i, j) == close(0.0));
            CHECK(one.derivative(i, j) == close(i + j == 0 ? 1.0 : 0.0));
        }
    }
}

TEST_CASE("whole powers have their derivatives at zero, too") {
    const Taylor zero = Taylor::y(0.0);
    CHECK(pow(zero, 1).derivative(0, 1) == 1.0);
    CHECK(pow(zero, 2).derivative(0, 2) == 2.0);
    CHECK(pow(zero, 3).derivative(0, 3) == 6.0);
    CHECK(pow(zero, 3).derivative(0, 1) == 0.0);
}
