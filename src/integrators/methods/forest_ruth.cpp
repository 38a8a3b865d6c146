#include <cmath>

#include "integrators/integrator.hpp"
#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

/// Forest-Ruth: symplectic integrator of fourth order, also found by Yoshida. Three steps of velocity Verlet with
/// lengths w1 dt, w0 dt, w1 dt, the middle one backwards in time,
///
///     w1 = 1 / (2 - 2^(1/3)) = 1.351...,   w0 = -2^(1/3) w1 = -1.702...,   2 w1 + w0 = 1,
///
/// whose third-order errors cancel. Time-reversible; three evaluations per step. Neighbouring half kicks are merged.
/// Source: Forest and Ruth (1990), doi:10.1016/0167-2789(90)90019-L; Yoshida (1990), doi:10.1016/0375-9601(90)90092-3
IntegratorMethod forest_ruth() {
    return {.name = "forest-ruth",
            .meaning = "symplectic composition of fourth order, three evaluations a step (Forest and Ruth 1990)",
            .order = 4,
            .reversible = true,
            .options = without_options([](double dt) -> Scheme {
                const double w1 = 1.0 / (2.0 - cube_root(2.0));
                const double w0 = 1.0 - 2.0 * w1;
                const double outer = 0.5 * w1 * dt;
                const double inner = 0.5 * (w1 + w0) * dt;
                return {.begin = {},
                        .cycle = {{Kick{outer}, Drift{w1 * dt}, Evaluate{}, Kick{inner}, Drift{w0 * dt}, Evaluate{},
                                   Kick{inner}, Drift{w1 * dt}, Evaluate{}, Kick{outer}}},
                        .reverse = {}};
            })};
}

}  // namespace ljmd
