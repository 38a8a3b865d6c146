#include "ljmd/execution/threads.hpp"
#include "ljmd/integrators/integrator.hpp"

namespace ljmd {

namespace {

/// Both from the values at the start of the step: the position first, with the old velocity.
void euler_step(State& state, double dt) {
    const auto f = static_cast<const State&>(state).forces();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for_each_index(state.count(), [&](Index i) {
        r.col(i) = state.snapped(r.col(i) + dt * v.col(i));
        v.col(i) += dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i);
    });
}

}  // namespace

/// Explicit Euler:
///
///     r(t + dt) = r(t) + dt v(t)
///     v(t + dt) = v(t) + (dt/m) f(t)
///
/// First order, neither symplectic nor reversible: an oscillator gains energy by the factor 1 + (omega dt)^2 each step.
/// Here to be compared with, not to be used.
/// Source: Euler, Institutionum calculi integralis I (1768), section 650
IntegratorMethod euler() {
    return {.name = "euler",
            .meaning = "drift and kick with the old values; first order, gains energy; for comparison",
            .order = 1,
            .reversible = false,
            .options = without_options([](double dt) -> Scheme {
                const Update advance{[dt](State& state) { euler_step(state, dt); }};
                return {.begin = {}, .cycle = {{advance, Evaluate{}}}, .reverse = {}};
            })};
}

}  // namespace ljmd
