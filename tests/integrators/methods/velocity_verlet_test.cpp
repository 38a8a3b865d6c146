#include "catch.hpp"

#include "integrators/integrator.hpp"
#include "integrators/oscillator.hpp"

using namespace ljmd;

namespace {
constexpr double dt = 0.125;

State after(Index steps, test::Oscillator& springs) {
    State state = test::swinging(springs);
    for (Index n = 0; n < steps; ++n) {
        Integrator(find_integrator("velocity-verlet"), dt).step(state, springs, Request::forces);
    }
    return state;
}
}  // namespace

TEST_CASE("a step of velocity Verlet is half kick, drift, half kick") {
    test::Oscillator springs(2.0);
    const State start = after(0, springs);
    const State end = after(1, springs);
    for (Index i = 0; i < 2; ++i) {
        const double mass = start.masses()[static_cast<std::size_t>(i)];
        const Vec3 v_half = start.velocities().col(i) + dt / 2.0 / mass * start.forces().col(i);
        const Vec3 r = start.positions().col(i) + dt * v_half;
        const Vec3 v = v_half + dt / 2.0 / mass * (-2.0 * r);
        CHECK((end.positions().col(i) - r).norm() < 1e-15);
        CHECK((end.velocities().col(i) - v).norm() < 1e-15);
    }
}

TEST_CASE("velocity Verlet evaluates the forces once a step, and leaves them current") {
    test::Oscillator springs(2.0);
    const State end = after(7, springs);
    CHECK(end.forces_are_current());
    CHECK(springs.requests().size() == 1 + 7);
}

TEST_CASE("positions of velocity Verlet follow Verlet's formula r(t + dt) = 2 r(t) - r(t - dt) + dt^2 f(t) / m") {
    test::Oscillator springs(2.0);
    for (const Index n : {1, 2, 20}) {
        const Eigen::Matrix3Xd before = after(n - 1, springs).positions();
        const State now = after(n, springs);
        const Eigen::Matrix3Xd next = after(n + 1, springs).positions();
        for (Index i = 0; i < 2; ++i) {
            const Vec3 acceleration = now.forces().col(i) / now.masses()[static_cast<std::size_t>(i)];
            const Vec3 verlet = 2.0 * now.positions().col(i) - before.col(i) + dt * dt * acceleration;
            CHECK((next.col(i) - verlet).norm() < 1e-14);
        }
    }
}

TEST_CASE("velocity Verlet conserves the energy that the method has in the place of the true one") {
    // For a harmonic oscillator v^2 + (1 - (omega dt/2)^2) omega^2 x^2 is constant to round-off, at any step below
    // 2/omega.
    test::Oscillator springs(2.0);
    const auto shadow = [&](const State& state, Index i) {
        const double omega = springs.frequency(state.masses()[static_cast<std::size_t>(i)]);
        const double factor = omega * omega * (1.0 - 0.25 * omega * omega * dt * dt);
        return state.velocities().col(i).squaredNorm() + factor * state.positions().col(i).squaredNorm();
    };
    const State start = after(0, springs);
    for (const Index steps : {1, 13, 1000}) {
        const State end = after(steps, springs);
        for (Index i = 0; i < 2; ++i) {
            CHECK(std::abs(shadow(end, i) - shadow(start, i)) < 1e-12 * shadow(start, i));
        }
    }
}
