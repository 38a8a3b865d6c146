#include "integrators/thermostat.hpp"

#include <algorithm>
#include <cmath>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "integrators/thermostats/made_thermostat.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "model/velocities.hpp"

using namespace ljmd;

TEST_CASE("thermostats are listed by name, in alphabetical order, with a meaning") {
    const auto methods = all_thermostats();
    const std::vector<std::string> names = plugin_names(methods);
    CHECK(std::is_sorted(names.begin(), names.end()));
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    CHECK(std::find(names.begin(), names.end(), "rescale") != names.end());
    for (const auto& method : methods) {
        CHECK_FALSE(method.meaning.empty());
        CHECK(find_thermostat(method.name).name == method.name);
    }
    CHECK_THROWS_AS(find_thermostat("ice"), InputError);
    CHECK_THROWS_WITH(find_thermostat("ice"), Catch::Contains("thermostat") && Catch::Contains("rescale"));
}

TEST_CASE("every thermostat can be made with its defaults, acts on velocities alone and counts the heat") {
    for (const auto& method : all_thermostats()) {
        CAPTURE(method.name);
        State state = test::moving_atoms(1.3);
        state.mark_forces_current();
        const auto thermostat = test::made_thermostat(method.name, test::bath_of(state, 0.7));
        state.bath = thermostat->beginning();
        CHECK(state.heat() == 0.0);
        const Eigen::Matrix3Xd positions = static_cast<const State&>(state).positions();
        const double before = kinetic_energy(state);
        for (Index step = 1; step <= 200; ++step) {
            test::act(*thermostat, state, step);
        }
        CHECK(static_cast<const State&>(state).positions() == positions);
        CHECK(state.forces_are_current());
        CHECK(static_cast<const State&>(state).velocities().allFinite());
        CHECK(std::abs(kinetic_energy(state) - before) > 1.0);
        CHECK(state.bath.size() == thermostat->beginning().size());
        const double tolerance = method.name == "nose-hoover-chain" ? 1e-4 : 1e-12;  // of its integration
        CHECK(state.heat() == Approx(kinetic_energy(state) - before).epsilon(tolerance));
    }
}

TEST_CASE("thermostats conserve momentum, or say that they do not") {
    for (const auto& method : all_thermostats()) {
        CAPTURE(method.name);
        State state = test::moving_atoms(1.3);
        const auto thermostat = test::made_thermostat(method.name, test::bath_of(state, 0.7));
        state.bath = thermostat->beginning();
        for (Index step = 1; step <= 200; ++step) {
            test::act(*thermostat, state, step);
        }
        CHECK((total_momentum(state).norm() < 1e-10) == method.conserves_momentum);
    }
}

TEST_CASE("what a thermostat does depends on ids and steps, not on the order of atoms or on threads") {
    for (const auto& method : all_thermostats()) {
        CAPTURE(method.name);
        std::vector<State> ends;
        for (const bool reordered : {false, true, true}) {
            State state = test::moving_atoms(1.3, reordered, test::with_threads(ends.size() == 2 ? 3 : 1));
            const auto thermostat = test::made_thermostat(method.name, test::bath_of(state, 0.7));
            state.bath = thermostat->beginning();
            for (Index step = 1; step <= 50; ++step) {
                test::act(*thermostat, state, step);
            }
            ends.push_back(state);
        }
        const auto velocities_of = [](const State& state) {
            Eigen::Matrix3Xd v(3, state.count());
            for (Index i = 0; i < state.count(); ++i) {
                v.col(state.ids()[static_cast<std::size_t>(i)]) = state.velocities().col(i);
            }
            return v;
        };
        CHECK((velocities_of(ends[0]) - velocities_of(ends[1])).norm() < 1e-11);  // sums in another order
        CHECK(velocities_of(ends[1]) == velocities_of(ends[2]));
        CHECK(ends[1].bath == ends[2].bath);
    }
}

TEST_CASE(
    "canonical thermostats that draw numbers do something else with another seed or at another step, and the same with "
    "the same") {
    for (const ThermostatMethod& method : all_thermostats()) {
        if (method.deterministic || !method.canonical) {
            continue;
        }
        CAPTURE(method.name);
        const auto after = [&](std::uint64_t seed, Index step) {
            State state = test::moving_atoms(1.3);
            HeatBath bath = test::bath_of(state, 0.7);
            bath.seed = seed;
            test::act(*test::made_thermostat(method.name, bath, {{"time", 0.05}}), state, step);
            return state.heat();
        };
        CHECK(after(1, 1) == after(1, 1));
        CHECK(after(1, 1) != after(2, 1));
        CHECK(after(1, 1) != after(1, 2));
    }
}

TEST_CASE("one atom, and atoms at rest, are no trouble") {
    for (const auto& method : all_thermostats()) {
        CAPTURE(method.name);
        for (const Index atoms : {1, 10}) {
            State state(atoms, Box(Vec3::Constant(5.0)));
            const auto thermostat = test::made_thermostat(method.name, test::bath_of(state, 0.7));
            state.bath = thermostat->beginning();
            for (Index step = 1; step <= 20; ++step) {
                test::act(*thermostat, state, step);
            }
            CHECK(static_cast<const State&>(state).velocities().allFinite());
            CHECK(std::isfinite(state.heat()));
        }
    }
}
