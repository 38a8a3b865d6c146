#include "integrators/integrator.hpp"

namespace ljmd {

/// Drift-kick-drift, the adjoint of velocity Verlet, also called position Verlet (Tuckerman et al.):
///
///     r(t + dt/2) = r(t) + (dt/2) v(t)
///     v(t + dt)   = v(t) + (dt/m) f(t + dt/2)
///     r(t + dt)   = r(t + dt/2) + (dt/2) v(t + dt)
///
/// Second order, time-reversible, symplectic. The motion needs forces at half steps only. The second evaluation gives
/// energy and pressure at t + dt for reports. It is made at every step, so that the choice of reports cannot change the
/// motion.
/// Source: Tuckerman, Berne and Martyna (1992), doi:10.1063/1.463137
IntegratorMethod drift_kick_drift() {
    return {.name = "drift-kick-drift",
            .meaning = "half drift, kick, half drift: the mirror image of velocity Verlet (Tuckerman et al. 1992)",
            .order = 2,
            .reversible = true,
            .options = without_options([](double dt) -> Scheme {
                return {.begin = {},
                        .cycle = {{Drift{0.5 * dt}, Evaluate{}, Kick{dt}, Drift{0.5 * dt}, Evaluate{}}},
                        .reverse = {}};
            })};
}

}  // namespace ljmd
