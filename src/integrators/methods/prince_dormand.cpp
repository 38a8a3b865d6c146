#include "ljmd/integrators/integrator.hpp"
#include "ljmd/integrators/reference_trajectory.hpp"

namespace ljmd {

namespace {

constexpr double tolerance = 1e-13;  // of a sub-step, relative and absolute

/// Over one time step, in as many steps of its own as the tolerance asks for.
void solve(State& state, ForceField& force_field, double dt, const StateWatch& within) {
    ReferenceTrajectory trajectory(state, force_field, tolerance);
    const State& end = trajectory.advance_by(dt, within);
    const std::vector<Index> index_of = end.index_of();
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for (Index i = 0; i < state.count(); ++i) {
        const Index k = index_of[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])];
        r.col(i) = end.positions().col(k);
        v.col(i) = end.velocities().col(k);
    }
}

}  // namespace

/// The adaptive Runge-Kutta method of Prince and Dormand, order 8 with an embedded one of order 9 that chooses the
/// steps (GSL's rk8pd): what fixed steps are measured against, and the method for close encounters of a few bodies.
///
/// The time step of the deck is that of the output; within it the method takes as many steps as keep the error of each
/// below 1e-13 (1 + |value|), and what is measured sees these steps, too. Neither symplectic nor reversible, but nearly
/// exact. For systems without a box: the forces of a fluid, cut off, are not smooth enough for it, and its motion too
/// chaotic for it to be of use. Source: Prince and Dormand (1981), doi:10.1016/0771-050X(81)90010-3
IntegratorMethod prince_dormand() {
    return {.name = "prince-dormand",
            .meaning = "adaptive Runge-Kutta of order 8, nearly exact (Prince and Dormand 1981); few bodies only",
            .order = 8,
            .reversible = false,
            .adaptive = true,
            .unbounded_only = true,
            .options = without_options([](double dt) -> Scheme {
                const Solve advance{[dt](State& state, ForceField& force_field, const StateWatch& within) {
                    solve(state, force_field, dt, within);
                }};
                return {.begin = {}, .cycle = {{advance, Evaluate{}}}, .reverse = {}};
            })};
}

}  // namespace ljmd
