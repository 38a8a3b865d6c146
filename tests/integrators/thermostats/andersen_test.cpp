#include <gsl/gsl_cdf.h>

#include <cmath>
#include "catch.hpp"

#include "core/kolmogorov_smirnov.hpp"
#include "integrators/thermostats/made_thermostat.hpp"

using namespace ljmd;

TEST_CASE("in a step each atom collides with the probability 1 - exp(-dt/tau_T), and is otherwise left alone") {
    State state = test::moving_atoms(1.3);
    const auto thermostat = test::made_thermostat("andersen", {0.7, 0.05, 3, 297}, {{"time", 0.25}});
    Index collisions = 0;
    constexpr Index steps = 2000;
    for (Index step = 1; step <= steps; ++step) {
        const Eigen::Matrix3Xd before = static_cast<const State&>(state).velocities();
        test::act(*thermostat, state, step);
        const auto after = static_cast<const State&>(state).velocities();
        for (Index i = 0; i < state.count(); ++i) {
            collisions += after.col(i) != before.col(i) ? 1 : 0;
        }
    }
    const double n = static_cast<double>(steps * state.count());
    const double p = 1.0 - std::exp(-0.2);
    CHECK(std::abs(static_cast<double>(collisions) - n * p) < 4.0 * std::sqrt(n * p * (1.0 - p)));
}

TEST_CASE("after a collision a velocity is one of Maxwell's distribution for the mass of the atom") {
    State state(10, Box(Vec3::Constant(5.0)));
    state.write_masses() = {1.0, 1.0, 1.0, 1.0, 1.0, 4.0, 4.0, 4.0, 4.0, 4.0};
    state.bath = {0.0};
    const auto thermostat = test::made_thermostat("andersen", {0.7, 0.05, 3, 27}, {{"time", 1e-9}});
    std::vector<double> scaled;
    for (Index step = 1; step <= 1000; ++step) {
        test::act(*thermostat, state, step);
        for (Index i = 0; i < state.count(); ++i) {
            const double width = std::sqrt(0.7 / state.masses()[static_cast<std::size_t>(i)]);
            for (int a = 0; a < 3; ++a) {
                scaled.push_back(static_cast<const State&>(state).velocities()(a, i) / width);
            }
        }
    }
    CHECK(test::kolmogorov_smirnov(scaled, [](double x) { return gsl_cdf_ugaussian_P(x); }) < 1.63);
}
