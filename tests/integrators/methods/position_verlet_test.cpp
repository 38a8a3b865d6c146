#include "catch.hpp"

#include "integrators/oscillator.hpp"

using namespace ljmd;

namespace {

State after(const std::string& start, double dt, Index steps, test::Oscillator& springs) {
    State state = test::swinging(springs);
    test::advance("position-verlet", {{"start", start}}, dt, steps, state, springs);
    return state;
}

}  // namespace

TEST_CASE("the starts of position Verlet put the second position where they say") {
    test::Oscillator springs(2.0);
    const double dt = 0.125;
    const State start = test::swinging(springs);
    for (Index i = 0; i < 2; ++i) {
        const Vec3 r = start.positions().col(i);
        const Vec3 euler = r + dt * start.velocities().col(i);
        const Vec3 a = start.forces().col(i) / start.masses()[static_cast<std::size_t>(i)];
        CHECK((after("euler", dt, 1, springs).positions().col(i) - euler).norm() < 1e-15);
        CHECK((after("taylor", dt, 1, springs).positions().col(i) - (euler + 0.5 * dt * dt * a)).norm() < 1e-15);
        CHECK((after("backward", dt, 1, springs).positions().col(i) - (euler + 0.5 * dt * dt * a)).norm() < 1e-15);
    }
}

TEST_CASE("position Verlet follows r(t + dt) = 2 r(t) - r(t - dt) + dt^2 f / m, velocities are central differences") {
    test::Oscillator springs(2.0);
    const double dt = 0.125;
    for (const std::string start : {"euler", "taylor", "backward"}) {
        for (const Index n : {2, 3, 20}) {
            const State before = after(start, dt, n - 1, springs);
            const State now = after(start, dt, n, springs);
            const State next = after(start, dt, n + 1, springs);
            for (Index i = 0; i < 2; ++i) {
                const Vec3 a = now.forces().col(i) / now.masses()[static_cast<std::size_t>(i)];
                const Vec3 verlet = 2.0 * now.positions().col(i) - before.positions().col(i) + dt * dt * a;
                CHECK((next.positions().col(i) - verlet).norm() < 1e-14);
                const Vec3 difference = (next.positions().col(i) - before.positions().col(i)) / (2.0 * dt);
                CHECK((now.velocities().col(i) - difference).norm() < 1e-14);
            }
        }
    }
}

TEST_CASE("position Verlet started by Taylor is velocity Verlet to rounding, started by Euler it is of first order") {
    test::Oscillator springs(2.0);
    const auto miss = [&](const std::string& start, double dt) {
        State verlet = test::swinging(springs);
        const auto steps = static_cast<Index>(std::lround(5.0 / dt));
        test::advance("velocity-verlet", {}, dt, steps, verlet, springs);
        return (after(start, dt, steps, springs).positions() - test::positions(verlet)).norm();
    };
    CHECK(miss("taylor", 0.01) < 1e-12);
    CHECK(miss("backward", 0.01) < 1e-12);
    CHECK(std::log2(miss("euler", 0.01) / miss("euler", 0.005)) == Approx(1.0).margin(0.02));
}

TEST_CASE(
    "the phase of an oscillator advances by w' dt a step, cos(w' dt) = 1 - (w dt)^2 / 2, and runs away for w dt > 2") {
    test::Oscillator springs(2.0);
    const double omega = std::sqrt(2.0);
    for (const double dt : {0.1, 0.7, 1.4}) {
        State state(1);
        state.write_positions()(0, 0) = 1.0;
        test::advance("position-verlet", {}, dt, 25, state, springs);
        const double phase = std::acos(1.0 - 0.5 * std::pow(omega * dt, 2));
        CHECK(test::positions(state)(0, 0) == Approx(std::cos(25.0 * phase)).margin(1e-12));
    }
    State lost(1);
    lost.write_positions()(0, 0) = 1.0;
    test::advance("position-verlet", {}, 2.05 / omega, 100, lost, springs);
    CHECK(std::abs(test::positions(lost)(0, 0)) > 1e10);
}
