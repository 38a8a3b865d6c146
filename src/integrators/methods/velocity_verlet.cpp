#include "integrators/integrator.hpp"

namespace ljmd {

/// Velocity Verlet: half kick, drift, evaluate, half kick.
///
///     v(t + dt/2) = v(t) + (dt/2m) f(t)
///     r(t + dt)   = r(t) + dt v(t + dt/2)
///     v(t + dt)   = v(t + dt/2) + (dt/2m) f(t + dt)
///
/// Second order, time-reversible, symplectic. Positions are the same as by Verlet's formula of 1967 with the same
/// start.
/// Source: Swope, Andersen, Berens and Wilson (1982), doi:10.1063/1.442716
IntegratorMethod velocity_verlet() {
    return {.name = "velocity-verlet",
            .meaning = "half kick, drift, half kick (Swope et al. 1982)",
            .order = 2,
            .reversible = true,
            .takes_thermostat = true,
            .options = without_options([](double dt) -> Scheme {
                return {.begin = {}, .cycle = {{Kick{0.5 * dt}, Drift{dt}, Evaluate{}, Kick{0.5 * dt}}}, .reverse = {}};
            })};
}

}  // namespace ljmd
