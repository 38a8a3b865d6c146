#include "execution/loops.hpp"
#include "integrators/integrator.hpp"

namespace ljmd {

namespace {

constexpr const char* half_step_velocities = "leapfrog: velocities half a step ago";

/// out = in + (dt/m) f for each atom.
template <class In, class Out>
void kicked(const State& state, double dt, const In& in, Out&& out) {
    for_each_index(state.execution(), state.count(), [&](Index i) {
        out.col(i) = in.col(i) + dt / state.masses()[static_cast<std::size_t>(i)] * state.forces().col(i);
    });
}

/// v(-dt/2) = v(0) - (dt/2m) f(0)
void begin(State& state, double dt) {
    auto u = state.registered(state.register_vectors(half_step_velocities));
    kicked(state, -0.5 * dt, state.velocities(), u);
}

void leap(State& state, double dt) {
    auto u = state.registered(state.register_vectors(half_step_velocities));
    kicked(state, dt, u, u);
    auto r = state.write_positions();
    for_each_index(state.execution(), state.count(),
                   [&](Index i) { r.col(i) = state.snapped(r.col(i) + dt * u.col(i)); });
}

void synchronise(State& state, double dt) {
    const auto u = state.registered(state.register_vectors(half_step_velocities));
    kicked(state, 0.5 * dt, u, state.write_velocities());
}

/// Backwards in time, the reversed v(t + dt/2) takes the place of v(t - dt/2).
void reverse(State& state, double dt) {
    auto u = state.registered(state.register_vectors(half_step_velocities));
    kicked(state, dt, u, u);
    u *= -1.0;
    state.write_velocities() *= -1.0;
}

}  // namespace

/// Leapfrog with half-step velocities:
///
///     v(t + dt/2) = v(t - dt/2) + (dt/m) f(t)
///     r(t + dt)   = r(t) + dt v(t + dt/2)
///
/// started with v(-dt/2) = v(0) - (dt/2m) f(0). Reported velocities are synchronised: v(t) = v(t - dt/2) + (dt/2m)
/// f(t). Within rounding these are the velocities and positions of velocity Verlet. Second order, time-reversible,
/// symplectic.
/// Source: Hockney and Eastwood, Computer Simulation Using Particles (1988), section 4-4-1;
///         Feynman, Leighton and Sands, The Feynman Lectures on Physics I (1963), section 9-6
IntegratorMethod leapfrog() {
    return {.name = "leapfrog",
            .meaning = "velocities at half steps; those reported are synchronised (Hockney and Eastwood 1988)",
            .order = 2,
            .reversible = true,
            .options = without_options([](double dt) -> Scheme {
                return {.begin = {Update{[dt](State& state) { begin(state, dt); }}},
                        .cycle = {{Update{[dt](State& state) { leap(state, dt); }, dt}, Evaluate{},
                                   Update{[dt](State& state) { synchronise(state, dt); }}}},
                        .reverse = {Update{[dt](State& state) { reverse(state, dt); }}}};
            })};
}

}  // namespace ljmd
