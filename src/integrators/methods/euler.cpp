#include "execution/loops.hpp"
#include "integrators/integrator.hpp"

namespace ljmd {

namespace {

/// Both changes use the values at the start of the step, so the position comes first.
void euler_step(State& state, double dt) {
    const auto f = static_cast<const State&>(state).forces();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) {
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
/// First order, neither symplectic nor reversible: the energy of an oscillator grows by a factor of 1 + (omega dt)^2
/// per step. For comparison only.
/// Source: Euler, Institutionum calculi integralis I (1768), section 650
IntegratorMethod euler() {
    return {.name = "euler",
            .meaning = "drift and kick with the old values; first order, gains energy; for comparison",
            .order = 1,
            .reversible = false,
            .options = without_options([](double dt) -> Scheme {
                const Update advance{[dt](State& state) { euler_step(state, dt); }, dt};
                return {.begin = {}, .cycle = {{advance, Evaluate{}}}, .reverse = {}};
            })};
}

}  // namespace ljmd
