#include <cmath>
#include "catch.hpp"

#include "core/random.hpp"
#include "integrators/thermostats/made_thermostat.hpp"

using namespace ljmd;

TEST_CASE("Langevin's thermostat acts half-way of the drift: v = c v + sqrt((1 - c^2) T/m) xi") {
    State state = test::moving_atoms(1.3);
    state.write_masses()[4] = 9.0;
    const auto thermostat = test::made_thermostat("langevin", {0.7, 0.05, 3, 297}, {{"time", 0.1}});
    CHECK(thermostat->acts_mid_drift());
    const Eigen::Matrix3Xd before = static_cast<const State&>(state).velocities();
    state.step = 12;
    thermostat->before_step(state);
    thermostat->after_step(state, 12);
    CHECK(static_cast<const State&>(state).velocities() == before);
    thermostat->mid_drift(state);
    const double c = std::exp(-0.5);
    const Random random(3, RandomStream::thermostat);
    for (const Index i : {0, 4, 99}) {
        const double width = std::sqrt((1.0 - c * c) * 0.7 / state.masses()[static_cast<std::size_t>(i)]);
        const Vec3 expected = c * before.col(i) + width * random.normal(12, i);
        CHECK((static_cast<const State&>(state).velocities().col(i) - expected).norm() < 1e-14);
    }
}

TEST_CASE("it cools to rest at T = 0, as friction alone does") {
    State state = test::moving_atoms(1.3);
    const double before = kinetic_energy(state);
    const auto thermostat = test::made_thermostat("langevin", {0.0, 0.01, 3, 297}, {{"time", 0.5}});
    for (Index step = 1; step <= 100; ++step) {
        test::act(*thermostat, state, step);
    }
    CHECK(kinetic_energy(state) == Approx(before * std::exp(-2.0 * 1.0 / 0.5)).epsilon(1e-12));
}
