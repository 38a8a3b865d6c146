#include "reference/multiparameter.hpp"

#include <cmath>
#include "catch.hpp"

using namespace ljmd;

namespace {

constexpr double reducing_temperature = 1.5;
constexpr double reducing_density = 0.4;
constexpr double temperature = 1.2;
constexpr double density = 0.3;
constexpr double tau = reducing_temperature / temperature;
constexpr double delta = density / reducing_density;

double value(const MultiparameterForm& form) {
    return residual_helmholtz(form, temperature, density).value();
}

}  // namespace

TEST_CASE("each kind of term is its formula") {
    MultiparameterForm form{reducing_temperature, reducing_density, {}, {}, {}};
    CHECK(value(form) == 0.0);
    form.power = {{-2.0, 0.32, 3}};
    const double power = -2.0 * std::pow(tau, 0.32) * std::pow(delta, 3);
    CHECK(value(form) == Approx(power).epsilon(1e-14));
    form.exponential = {{0.7, 1.29, 2, 2}};
    const double exponential = 0.7 * std::pow(tau, 1.29) * std::pow(delta, 2) * std::exp(-delta * delta);
    CHECK(value(form) == Approx(power + exponential).epsilon(1e-14));
    form.gaussian = {{1.4, 2.83, 1, 2.067, 0.625, 0.71, 0.2053}};
    const double gaussian = 1.4 * std::pow(tau, 2.83) * delta *
                            std::exp(-2.067 * std::pow(delta - 0.2053, 2) - 0.625 * std::pow(tau - 0.71, 2));
    CHECK(value(form) == Approx(power + exponential + gaussian).epsilon(1e-14));
}

TEST_CASE("terms of one kind are added") {
    const MultiparameterForm one{reducing_temperature, reducing_density, {{1.0, 1.0, 1}}, {}, {}};
    const MultiparameterForm other{reducing_temperature, reducing_density, {{2.0, 0.5, 4}}, {}, {}};
    const MultiparameterForm both{reducing_temperature, reducing_density, {{1.0, 1.0, 1}, {2.0, 0.5, 4}}, {}, {}};
    CHECK(value(both) == Approx(value(one) + value(other)).epsilon(1e-14));
}
