#include "ljmd/integrators/thermostat.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "integrators/thermostats/made_thermostat.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/registry.hpp"
#include "ljmd/model/velocities.hpp"

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

TEST_CASE("every thermostat can be made with its defaults and acts on velocities alone") {
    for (const auto& method : all_thermostats()) {
        CAPTURE(method.name);
        State state(50, Box(Vec3::Constant(5.0)));
        draw_velocities(state, 1.3, 4);
        state.mark_forces_current();
        const auto thermostat = test::made_thermostat(method.name, 0.7, {});
        const Eigen::Matrix3Xd positions = static_cast<const State&>(state).positions();
        for (Index step = 1; step <= 200; ++step) {
            thermostat->apply(state, step);
        }
        CHECK(static_cast<const State&>(state).positions() == positions);
        CHECK(state.forces_are_current());
        CHECK(static_cast<const State&>(state).velocities().allFinite());
        CHECK(*temperature(state) != 1.3);
    }
}
