#include "execution/loops.hpp"
#include "integrators/integrator.hpp"

namespace ljmd {

namespace {

constexpr const char* start_of_step = "rk2-midpoint: velocities at the start of the step";

void half_euler_step(State& state, double dt) {
    auto v_start = state.registered(state.register_vectors(start_of_step));
    const auto f = static_cast<const State&>(state).forces();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        v_start.col(i) = v.col(i);
        r.col(i) = state.snapped(r.col(i) + 0.5 * dt * v.col(i));
        v.col(i) += 0.5 * dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i);
    });
}

/// The evaluation may have wrapped positions, so the half step is undone as a displacement.
void full_step_from_midpoint(State& state, double dt) {
    const auto v_start = state.registered(state.register_vectors(start_of_step));
    const auto f = static_cast<const State&>(state).forces();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) {
        r.col(i) = state.snapped(r.col(i) - 0.5 * dt * v_start.col(i) + dt * v.col(i));
        v.col(i) = v_start.col(i) + dt / state.masses()[static_cast<std::size_t>(i)] * f.col(i);
    });
}

}  // namespace

/// Runge's midpoint method: half an Euler step, whose slopes are then used for the whole step.
///
///     r' = r(t) + (dt/2) v(t)          v' = v(t) + (dt/2m) f(r(t))
///     r(t + dt) = r(t) + dt v'         v(t + dt) = v(t) + (dt/m) f(r')
///
/// Second order, neither symplectic nor reversible: the energy drifts, at third order in dt. For comparison.
/// Source: Runge (1895), doi:10.1007/BF01446807
IntegratorMethod rk2_midpoint() {
    return {.name = "rk2-midpoint",
            .meaning = "Runge-Kutta of second order by the midpoint (Runge 1895); for comparison",
            .order = 2,
            .reversible = false,
            .options = without_options([](double dt) -> Scheme {
                const Update to_midpoint{[dt](State& state) { half_euler_step(state, dt); }, 0.5 * dt};
                const Update to_end{[dt](State& state) { full_step_from_midpoint(state, dt); }, 0.5 * dt};
                return {.begin = {}, .cycle = {{to_midpoint, Evaluate{}, to_end, Evaluate{}}}, .reverse = {}};
            })};
}

}  // namespace ljmd
