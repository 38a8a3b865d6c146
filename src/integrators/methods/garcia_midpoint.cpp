#include "execution/loops.hpp"
#include "integrators/integrator.hpp"

namespace ljmd {

namespace {

void garcia_step(State& state, double dt) {
    const auto f = static_cast<const State&>(state).forces();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        const Vec3 v_old = v.col(i);
        v.col(i) += dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i);
        r.col(i) = state.snapped(r.col(i) + 0.5 * dt * (v_old + v.col(i)));
    });
}

}  // namespace

/// Midpoint method of Garcia's textbook: the position moves with the mean of old and new velocity.
///
///     v(t + dt) = v(t) + (dt/m) f(t)
///     r(t + dt) = r(t) + dt (v(t) + v(t + dt)) / 2
///
/// Within a step the position is correct to second order, but the velocity is not, so the global error is of first
/// order. It is not the Runge-Kutta midpoint method (see rk2-midpoint). For comparison.
/// Source: A. L. Garcia, Numerical Methods for Physics, 2nd ed. (2000), section 2.1
IntegratorMethod garcia_midpoint() {
    return {
        .name = "garcia-midpoint",
        .meaning = "kick, then drift with the mean of old and new velocity; first order (Garcia 2000); for comparison",
        .order = 1,
        .reversible = false,
        .options = without_options([](double dt) -> Scheme {
            const Update advance{[dt](State& state) { garcia_step(state, dt); }, dt};
            return {.begin = {}, .cycle = {{advance, Evaluate{}}}, .reverse = {}};
        })};
}

}  // namespace ljmd
