#include "integrators/integrator.hpp"

#include <algorithm>
#include "catch.hpp"

#include "integrators/oscillator.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"

using namespace ljmd;

namespace {

/// Largest deviation from the exact swing at the end of any step, positions and velocities together.
double largest_error(const Integrator& integrator, double dt, Index steps) {
    test::Oscillator springs(2.0);
    State state = test::swinging(springs);
    const State start = state;
    double largest = 0.0;
    for (Index n = 1; n <= steps; ++n) {
        integrator.step(state, springs, Request::forces);
        for (Index i = 0; i < state.count(); ++i) {
            const double omega = springs.frequency(state.masses()[static_cast<std::size_t>(i)]);
            const double phase = omega * dt * static_cast<double>(n);
            const Vec3 r0 = start.positions().col(i);
            const Vec3 v0 = start.velocities().col(i);
            const Vec3 r = std::cos(phase) * r0 + std::sin(phase) / omega * v0;
            const Vec3 v = std::cos(phase) * v0 - omega * std::sin(phase) * r0;
            largest = std::max(largest, std::hypot((test::positions(state).col(i) - r).norm(),
                                                   (test::velocities(state).col(i) - v).norm()));
        }
    }
    return largest;
}

void advance(const IntegratorMethod& method, double dt, Index steps, State& state, ForceField& springs) {
    const Integrator integrator(method, dt);
    for (Index n = 0; n < steps; ++n) {
        integrator.step(state, springs, Request::forces);
    }
}

/// Integer positions without a box are whole multiples of 2^-44, which also rounds the velocities that come of them.
double rounding_of(const IntegratorMethod& method) {
    return method.name == "bit-reversible" ? 5e-12 : 1e-12;
}

}  // namespace

TEST_CASE("every integrator has the order that it claims, in positions and reported velocities") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        if (method.adaptive) {
            CHECK(largest_error(Integrator(method, 0.5), 0.5, 8) < 1e-11);
            continue;
        }
        for (const double dt : {0.02, 0.01}) {
            const auto steps = static_cast<Index>(std::lround(4.0 / dt));
            const double order = std::log2(largest_error(Integrator(method, dt), dt, steps) /
                                           largest_error(Integrator(method, dt / 2), dt / 2, 2 * steps));
            CHECK(std::abs(order - method.order) < 0.05);
        }
    }
}

TEST_CASE("every integrator that claims it returns to its start when the motion is turned round, and no other does") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        for (const Index steps : {300, 301}) {
            test::Oscillator springs(2.0);
            State state = test::swinging(springs);
            const State start = state;
            const Integrator integrator(method, 0.1);
            for (int way = 0; way < 2; ++way) {
                advance(method, 0.1, steps, state, springs);
                if (way == 0) {
                    CHECK((test::positions(state) - start.positions()).norm() > 0.1);
                }
                integrator.reverse(state, springs);
            }
            const double miss = (test::positions(state) - start.positions()).norm() +
                                (test::velocities(state) - start.velocities()).norm();
            if (method.reversible) {
                CHECK(miss < rounding_of(method));
            } else if (!method.adaptive) {
                CHECK(miss > 1e-6);
            }
        }
    }
}

TEST_CASE("a run in two parts is the run in one, to the last bit, for every integrator") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        for (const Index first : {1, 2, 7}) {
            test::Oscillator springs(2.0);
            State whole = test::swinging(springs);
            State first_part = whole;
            advance(method, 0.1, 20, whole, springs);
            advance(method, 0.1, first, first_part, springs);
            State parts = first_part;  // what the next step needs is in the state
            advance(method, 0.1, 20 - first, parts, springs);
            CHECK(test::positions(parts) == test::positions(whole));
            CHECK(test::velocities(parts) == test::velocities(whole));
            CHECK(parts.phase().integrator == whole.phase().integrator);
            CHECK(parts.phase().steps == whole.phase().steps);
        }
    }
}

TEST_CASE("a start-up done before the first step changes no bit of the steps, nor does another one between them") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        test::Oscillator springs(2.0);
        State plain = test::swinging(springs);
        State prepared = plain;
        const Integrator integrator(method, 0.1);
        for (int n = 0; n < 5; ++n) {
            integrator.prepare(prepared, springs);
            const State before = prepared;
            integrator.prepare(prepared, springs);
            CHECK(test::positions(prepared) == before.positions());
            CHECK(test::velocities(prepared) == before.velocities());
            integrator.step(prepared, springs, Request::forces);
            integrator.step(plain, springs, Request::forces);
            CHECK(test::positions(prepared) == test::positions(plain));
            CHECK(test::velocities(prepared) == test::velocities(plain));
        }
    }
}

TEST_CASE("velocities that somebody else has changed are taken up by every integrator") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        test::Oscillator springs(2.0);
        State state = test::swinging(springs);
        advance(method, 0.01, 4, state, springs);
        state.write_velocities() *= 2.0;
        State fresh = test::swinging(springs);
        fresh.write_positions() = test::positions(state);
        fresh.write_velocities() = test::velocities(state);
        advance(method, 0.01, 4, state, springs);
        advance(method, 0.01, 4, fresh, springs);
        CHECK(test::positions(state) == test::positions(fresh));
        CHECK(test::velocities(state) == test::velocities(fresh));
    }
}

TEST_CASE(
    "every integrator leaves the forces current, whatever it was asked for, and returns the energy it was asked for") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        test::Oscillator springs(2.0);
        State state = test::swinging(springs);
        State silent = state;
        const Integrator integrator(method, 0.1);
        for (int n = 0; n < 3; ++n) {
            const Evaluation evaluation = integrator.step(state, springs, Request::forces_and_energy);
            CHECK(state.forces_are_current());
            CHECK(test::forces(state) == -2.0 * test::positions(state));
            CHECK(evaluation.potential_energy == test::positions(state).squaredNorm());
            CHECK(integrator.step(silent, springs, Request::forces).potential_energy == 0.0);
            CHECK(test::positions(state) == test::positions(silent));
        }
    }
}

TEST_CASE("every integrator moves free atoms in a straight line and needs no box") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        const double rounding = method.name == "bit-reversible" ? 1e-11 : 1e-14;
        test::Oscillator nothing(0.0);
        State state = test::swinging(nothing);
        const State start = state;
        advance(method, 0.125, 10, state, nothing);
        CHECK((test::positions(state) - (start.positions() + 1.25 * start.velocities())).norm() < rounding);
        CHECK((test::velocities(state) - start.velocities()).norm() < rounding);
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

TEST_CASE("what is to be done half-way of a drift is done there, and a drift in two halves is one drift") {
    test::Oscillator springs(2.0);
    State whole = test::swinging(springs);
    State halves = whole;
    State watched = whole;
    const Integrator integrator(find_integrator("velocity-verlet"), 0.1);
    const Integrator idle = integrator.with_mid_drift([](State&) {});
    std::vector<Eigen::Matrix3Xd> seen;
    const Integrator watching =
        integrator.with_mid_drift([&](State& state) { seen.emplace_back(test::positions(state)); });
    for (int n = 0; n < 10; ++n) {
        const Eigen::Matrix3Xd before = test::positions(watched);
        integrator.step(whole, springs, Request::forces);
        idle.step(halves, springs, Request::forces);
        watching.step(watched, springs, Request::forces);
        REQUIRE(seen.size() == static_cast<std::size_t>(n + 1));
        CHECK((seen.back() - 0.5 * (before + test::positions(watched))).norm() < 1e-14);
    }
    CHECK((test::positions(whole) - test::positions(halves)).norm() < 1e-14);
    CHECK((test::velocities(whole) - test::velocities(halves)).norm() < 1e-14);
}

TEST_CASE("every integrator says by how much its operators move the positions: one time step in all") {
    for (const IntegratorMethod& method : all_integrators()) {
        CAPTURE(method.name);
        for (const std::vector<Operator>& step : method.options()->scheme(0.3).cycle) {
            double moved = 0.0;
            bool solves = false;
            for (const Operator& op : step) {
                if (const auto* drift = std::get_if<Drift>(&op)) {
                    moved += drift->dt;
                } else if (const auto* update = std::get_if<Update>(&op)) {
                    moved += update->moves;
                }
                solves = solves || std::holds_alternative<Solve>(op);
            }
            CHECK(moved == Approx(solves ? 0.0 : 0.3));
        }
    }
}
