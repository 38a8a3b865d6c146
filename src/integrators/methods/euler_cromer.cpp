#include "integrators/integrator.hpp"

namespace ljmd {

/// Euler-Cromer, or symplectic Euler: the position moves with the new velocity.
///
///     v(t + dt) = v(t) + (dt/m) f(t)
///     r(t + dt) = r(t) + dt v(t + dt)
///
/// First order, symplectic, not time-reversible: the energy oscillates but does not drift. If v(0) is replaced by
/// v(-dt/2), the positions are the same as with leapfrog, which is of second order.
/// Source: Cromer (1981), doi:10.1119/1.12478
IntegratorMethod euler_cromer() {
    return {.name = "euler-cromer",
            .meaning = "kick, then drift with the new velocity; first order, symplectic (Cromer 1981)",
            .order = 1,
            .reversible = false,
            .options = without_options([](double dt) -> Scheme {
                return {.begin = {}, .cycle = {{Kick{dt}, Drift{dt}, Evaluate{}}}, .reverse = {}};
            })};
}

}  // namespace ljmd
