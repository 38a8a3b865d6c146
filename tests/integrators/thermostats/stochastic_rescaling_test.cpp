#include <gsl/gsl_cdf.h>

#include <cmath>
#include "catch.hpp"

#include "core/kolmogorov_smirnov.hpp"
#include "integrators/thermostats/made_thermostat.hpp"

using namespace ljmd;

TEST_CASE("stochastic rescaling multiplies all velocities by one factor") {
    State state = test::moving_atoms(1.3);
    const Eigen::Matrix3Xd before = static_cast<const State&>(state).velocities();
    test::act(*test::made_thermostat("stochastic-rescaling", test::bath_of(state, 0.7)), state, 1);
    const auto after = static_cast<const State&>(state).velocities();
    const double factor = after(0, 0) / before(0, 0);
    CHECK(factor != 1.0);
    CHECK((after - factor * before).norm() < 1e-13 * before.norm());
}

TEST_CASE("of atoms that nothing else moves the kinetic energy takes the canonical distribution") {
    State state(4, Box(Vec3::Constant(5.0)));
    draw_velocities(state, 3.0, 9);
    state.bath = {0.0};
    const auto thermostat = test::made_thermostat("stochastic-rescaling", test::bath_of(state, 0.7), {{"time", 0.05}});
    std::vector<double> reduced;  // K/T
    for (Index step = 1; step <= 200000; ++step) {
        test::act(*thermostat, state, step);
        if (step > 1000 && step % 100 == 0) {  // ten relaxation times
            reduced.push_back(kinetic_energy(state) / 0.7);
        }
    }
    CHECK(test::kolmogorov_smirnov(reduced, [](double k) { return gsl_cdf_gamma_P(k, 4.5, 1.0); }) < 1.63);
}

TEST_CASE("the kinetic energy forgets where it began with the time that was asked for") {
    // <K(t)> = K_eq + (K_0 - K_eq) exp(-t/tau_T), over many seeds.
    constexpr int runs = 400;
    double sum = 0.0;
    for (int seed = 0; seed < runs; ++seed) {
        State state = test::moving_atoms(1.3);
        HeatBath bath = test::bath_of(state, 0.7, 0.01);
        bath.seed = static_cast<std::uint64_t>(seed);
        const auto thermostat = test::made_thermostat("stochastic-rescaling", bath, {{"time", 0.4}});
        for (Index step = 1; step <= 40; ++step) {
            test::act(*thermostat, state, step);
        }
        sum += *temperature(state);
    }
    const double expected = 0.7 + 0.6 * std::exp(-1.0);
    const double width = 0.7 * std::sqrt(2.0 / 297.0);  // of T in equilibrium, and about that here
    CHECK(std::abs(sum / runs - expected) < 4.0 * width / std::sqrt(runs));
}

TEST_CASE("a single degree of freedom may turn round") {
    State state(1);
    state.write_velocities().col(0) = Vec3(1.0, 0.0, 0.0);
    state.bath = {0.0};
    const auto thermostat = test::made_thermostat("stochastic-rescaling", {1.0, 0.1, 5, 1}, {{"time", 0.1}});
    Index turns = 0;
    for (Index step = 1; step <= 1000; ++step) {
        const double before = static_cast<const State&>(state).velocities()(0, 0);
        test::act(*thermostat, state, step);
        turns += before * static_cast<const State&>(state).velocities()(0, 0) < 0.0 ? 1 : 0;
    }
    CHECK(turns > 100);
    CHECK(turns < 600);
}
