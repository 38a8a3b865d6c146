#include "integrators/integrator.hpp"
#include "integrators/reference_trajectory.hpp"

namespace ljmd {

namespace {

constexpr double tolerance = 1e-13;  // of a step of the method, relative and absolute

/// Advance by one time step, in as many steps of the method as the tolerance asks for.
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

/// Adaptive Runge-Kutta method of Prince and Dormand: order 8, with an embedded method that chooses the steps (GSL's
/// rk8pd). Fixed steps are measured against it; it also serves for close encounters of a few bodies.
///
/// The time step of the deck is for the output. Within it, the method takes as many steps as keep the error of each
/// below 1e-13 (1 + |value|); measurements see these steps, too. Neither symplectic nor reversible, but nearly exact.
/// Only for systems without a box: the truncated forces of a fluid are not smooth enough, and its motion is too chaotic
/// to benefit. Source: Prince and Dormand (1981), doi:10.1016/0771-050X(81)90010-3
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
