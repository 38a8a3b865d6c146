#include "ljmd/integrators/integrator.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "integrators/oscillator.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/registry.hpp"

using namespace ljmd;

namespace {

/// Largest deviation from the exact swing at the end of any step, positions and velocities together.
double largest_error(const IntegratorMethod& method, double dt, Index steps) {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const State start = state;
    const auto operators = method.step(dt);
    double largest = 0.0;
    for (Index n = 1; n <= steps; ++n) {
        apply(operators, state, springs, Request::forces);
        for (Index i = 0; i < state.count(); ++i) {
            const double omega = springs.frequency(state.masses()[static_cast<std::size_t>(i)]);
            const double phase = omega * dt * static_cast<double>(n);
            const Vec3 r0 = start.positions().col(i);
            const Vec3 v0 = start.velocities().col(i);
            const Vec3 r = std::cos(phase) * r0 + std::sin(phase) / omega * v0;
            const Vec3 v = std::cos(phase) * v0 - omega * std::sin(phase) * r0;
            largest = std::max(largest, std::hypot((static_cast<const State&>(state).positions().col(i) - r).norm(),
                                                   (static_cast<const State&>(state).velocities().col(i) - v).norm()));
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("every integrator has the order that it claims") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        for (const double dt : {0.02, 0.01}) {
            const auto steps = static_cast<Index>(std::lround(4.0 / dt));
            const double order = std::log2(largest_error(method, dt, steps) / largest_error(method, dt / 2, 2 * steps));
            CHECK(std::abs(order - method.order) < 0.05);
        }
    }
}

TEST_CASE("every integrator that claims it returns to its start when velocities are reversed") {
    for (const IntegratorMethod& method : all_integrators()) {
        if (!method.reversible) {
            continue;
        }
        CAPTURE(method.name);
        test::Oscillator springs(2.0);
        State state = test::swinging(springs);
        const State start = state;
        const auto operators = method.step(0.1);
        for (int way = 0; way < 2; ++way) {
            for (int n = 0; n < 300; ++n) {
                apply(operators, state, springs, Request::forces);
            }
            if (way == 0) {
                CHECK((static_cast<const State&>(state).positions() - start.positions()).norm() > 0.1);
            }
            state.write_velocities() *= -1.0;
        }
        CHECK((static_cast<const State&>(state).positions() - start.positions()).norm() < 1e-12);
        CHECK((static_cast<const State&>(state).velocities() - start.velocities()).norm() < 1e-12);
    }
}

TEST_CASE("every integrator moves free atoms in a straight line and needs no box") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        test::Oscillator nothing(0.0);
        State state = test::swinging(nothing);
        const State start = state;
        for (int n = 0; n < 10; ++n) {
            apply(method.step(0.125), state, nothing, Request::forces);
        }
        CHECK((static_cast<const State&>(state).positions() - (start.positions() + 1.25 * start.velocities())).norm() <
              1e-14);
        CHECK(static_cast<const State&>(state).velocities() == start.velocities());
    }
}

TEST_CASE("integrators are listed by name, in alphabetical order, with a meaning") {
    const auto methods = all_integrators();
    const std::vector<std::string> names = plugin_names(methods);
    CHECK(std::is_sorted(names.begin(), names.end()));
    CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
    CHECK(std::find(names.begin(), names.end(), "velocity-verlet") != names.end());
    for (const auto& method : methods) {
        CHECK_FALSE(method.meaning.empty());
        CHECK(method.order >= 1);
        CHECK(find_integrator(method.name).name == method.name);
    }
    CHECK_THROWS_AS(find_integrator("euler's"), InputError);
    CHECK_THROWS_WITH(find_integrator("euler's"), Catch::Contains("integrator") && Catch::Contains("velocity-verlet"));
}
