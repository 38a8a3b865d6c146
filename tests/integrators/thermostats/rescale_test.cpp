#include "catch.hpp"

#include "integrators/thermostats/made_thermostat.hpp"
#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

using namespace ljmd;

namespace {

HeatBath at(double temperature) {
    return {temperature, 0.005, 1, 297};
}

}  // namespace

TEST_CASE("rescaling sets the temperature at its schedule and leaves velocities alone between") {
    const auto thermostat = test::made_thermostat("rescale", at(0.722), {{"every", std::int64_t{5}}});
    State state = test::moving_atoms(1.5);
    for (Index step = 1; step <= 20; ++step) {
        state.write_velocities() *= 1.01;
        const Eigen::Matrix3Xd before = static_cast<const State&>(state).velocities();
        thermostat->after_step(state, step);
        CAPTURE(step);
        if (step % 5 == 0) {
            CHECK(*temperature(state) == Approx(0.722).epsilon(1e-14));
        } else {
            CHECK(static_cast<const State&>(state).velocities() == before);
        }
    }
}

TEST_CASE("rescaling multiplies all velocities by the same factor") {
    const auto thermostat = test::made_thermostat("rescale", at(0.5), {{"every", std::int64_t{1}}});
    State state = test::moving_atoms(2.0);
    const Eigen::Matrix3Xd before = static_cast<const State&>(state).velocities();
    thermostat->after_step(state, 1);
    CHECK((static_cast<const State&>(state).velocities() - 0.5 * before).norm() < 1e-14 * before.norm());
    CHECK(total_momentum(state).norm() < 1e-12);
}

TEST_CASE("rescaling happens every 20 steps unless told otherwise") {
    const auto thermostat = test::made_thermostat("rescale", at(0.5));
    State state = test::moving_atoms(2.0);
    thermostat->after_step(state, 19);
    CHECK(*temperature(state) == Approx(2.0));
    thermostat->after_step(state, 20);
    CHECK(*temperature(state) == Approx(0.5));
}

TEST_CASE("rescaling to T = 0 stops the atoms, atoms at rest, and a single atom, stay as they are") {
    const auto cold = test::made_thermostat("rescale", at(0.0), {{"every", std::int64_t{1}}});
    State state = test::moving_atoms(1.0);
    cold->after_step(state, 1);
    CHECK(static_cast<const State&>(state).velocities().isZero(0.0));

    const auto warm = test::made_thermostat("rescale", at(1.0), {{"every", std::int64_t{1}}});
    warm->after_step(state, 1);
    CHECK(static_cast<const State&>(state).velocities().isZero(0.0));

    State one(1, Box(Vec3::Constant(5.0)));
    one.bath = {0.0};
    one.write_velocities().col(0) = Vec3(1.0, 2.0, 3.0);
    warm->after_step(one, 1);
    CHECK(static_cast<const State&>(one).velocities().col(0) == Vec3(1.0, 2.0, 3.0));
}

TEST_CASE("what rescaling takes from the atoms is counted as heat") {
    const auto thermostat = test::made_thermostat("rescale", at(0.5), {{"every", std::int64_t{1}}});
    State state = test::moving_atoms(2.0);
    thermostat->after_step(state, 1);
    CHECK(state.heat() == Approx(0.5 * 297.0 * (0.5 - 2.0)).epsilon(1e-13));
    thermostat->after_step(state, 2);
    CHECK(state.heat() == Approx(0.5 * 297.0 * (0.5 - 2.0)).epsilon(1e-13));
}

TEST_CASE("a schedule of less than one step is refused") {
    CHECK_THROWS_AS(test::made_thermostat("rescale", at(1.0), {{"every", std::int64_t{0}}}), InputError);
    CHECK_THROWS_AS(test::made_thermostat("rescale", at(1.0), {{"every", std::int64_t{-3}}}), InputError);
}
