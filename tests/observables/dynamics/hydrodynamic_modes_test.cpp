#include "observables/dynamics/hydrodynamic_modes.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

constexpr double spacing = 0.05;

Eigen::VectorXd sampled(const SoundModes& modes, Index values) {
    return Eigen::VectorXd::NullaryExpr(
        values, [&](Index lag) { return modes.correlation(static_cast<double>(lag) * spacing); });
}

}  // namespace

TEST_CASE("modes begin at 1 with no slope, and their spectrum is the transform") {
    const SoundModes modes{.heat = 0.4, .heat_rate = 0.7, .damping = 0.5, .frequency = 3.0};
    CHECK(modes.correlation(0.0) == 1.0);
    CHECK((modes.correlation(1e-6) - 1.0) / 1e-6 == Approx(0.0).margin(1e-5));
    for (const double w : {0.0, 1.0, 3.0, 8.0}) {
        // Simpson's rule up to where nothing is left.
        constexpr int steps = 80000;
        constexpr double h = 40.0 / steps;
        double sum = 0.0;
        for (int n = 0; n <= steps; ++n) {
            const double weight = n == 0 || n == steps ? 1.0 : n % 2 == 1 ? 4.0 : 2.0;
            sum += weight * modes.correlation(n * h) * std::cos(w * n * h);
        }
        CHECK(modes.spectrum(w) == Approx(sum * h / 3.0 / std::numbers::pi).epsilon(1e-7));
    }
}

TEST_CASE("the modes that a function was made of are found again") {
    const double damping = GENERATE(0.2, 0.6, 1.2);
    const double heat = GENERATE(0.1, 0.4);
    const SoundModes made{.heat = heat, .heat_rate = 0.8, .damping = damping, .frequency = 4.0};
    CAPTURE(damping, heat);
    const auto found = fitted_sound(7.0 * sampled(made, 81), spacing, 3.0);
    REQUIRE(found);
    CHECK(found->heat == Approx(made.heat).epsilon(1e-6));
    CHECK(found->heat_rate == Approx(made.heat_rate).epsilon(1e-6));
    CHECK(found->damping == Approx(made.damping).epsilon(1e-6));
    CHECK(found->frequency == Approx(made.frequency).epsilon(1e-6));
}

TEST_CASE("noise moves the modes by little") {
    const SoundModes made{.heat = 0.3, .heat_rate = 1.0, .damping = 0.7, .frequency = 3.5};
    std::mt19937_64 generator(1);
    std::normal_distribution<double> normal(0.0, 0.01);
    const Eigen::VectorXd noisy = sampled(made, 81).unaryExpr([&](double f) { return f + normal(generator); });
    const auto found = fitted_sound(noisy, spacing, 3.0);
    REQUIRE(found);
    CHECK(std::abs(found->frequency - 3.5) < 0.1);
    CHECK(std::abs(found->damping - 0.7) < 0.1);
}

TEST_CASE("there is no sound where no side peak stands out, and none in what is not a correlation function") {
    const SoundModes damped{.heat = 0.5, .heat_rate = 0.8, .damping = 4.0, .frequency = 1.5};
    CHECK_FALSE(fitted_sound(sampled(damped, 81), spacing, 3.0));
    const Eigen::VectorXd decay =
        Eigen::VectorXd::NullaryExpr(81, [](Index lag) { return std::exp(-static_cast<double>(lag) * spacing); });
    CHECK_FALSE(fitted_sound(decay, spacing, 3.0));
    CHECK_FALSE(fitted_sound(Eigen::VectorXd::Zero(81), spacing, 3.0));
    CHECK_FALSE(fitted_sound(decay, spacing, std::nan("")));
    CHECK_FALSE(fitted_sound(decay, spacing, 1e16));
    CHECK_FALSE(fitted_sound(1e-32 * decay, spacing, 3.0));
    CHECK_THROWS_AS(fitted_sound(Eigen::VectorXd::Ones(7), spacing, 3.0), ContractViolation);
}

TEST_CASE("the viscosity is that of the rate at which a transverse current decays") {
    // exp(-nu k^2 t) with nu = eta/rho; the trapezoidal rule is high by (h nu k^2)^2/12.
    constexpr double k = 0.6;
    constexpr double viscosity = 3.2;
    constexpr double density = 0.8;
    const double rate = viscosity / density * k * k;
    const auto current = [&](Index values) {
        return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(
            values, [&](Index lag) { return 5.0 * std::exp(-rate * static_cast<double>(lag) * spacing); }));
    };
    const auto found = transverse_viscosity(current(161), spacing, k, density);
    REQUIRE(found);
    CHECK(*found == Approx(viscosity).epsilon(1e-3));
    CHECK_FALSE(transverse_viscosity(current(41), spacing, k, density));  // a fifth of it is left
    CHECK_THROWS_AS(transverse_viscosity(current(7), spacing, k, density), ContractViolation);
}
