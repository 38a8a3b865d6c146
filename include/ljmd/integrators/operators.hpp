#pragma once

#include <variant>
#include <vector>

#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// v += (dt/m) f. @pre forces current
struct Kick {
    double dt;  ///< [tau]
};

/// r += dt v, onto the grid of the box. Makes the forces stale.
struct Drift {
    double dt;  ///< [tau]
};

/// Compute the forces at the present positions.
struct Evaluate {};

/// An integrator is a list of these. A backend may fuse neighbouring ones.
using Operator = std::variant<Kick, Drift, Evaluate>;

/// Apply the operators of one step in order.
///
/// Shapes: positions, velocities, forces (3, N) [sigma, sigma/tau, epsilon/sigma]; masses (N) [m].
/// @param request  what the last Evaluate of the list is asked for
/// @return what the last Evaluate returned
/// @pre    state.forces_are_current() if a Kick comes before the first Evaluate
/// @throws ContractViolation when a Kick meets stale forces
Evaluation apply(const std::vector<Operator>& operators, State& state, ForceField& force_field, Request request);

}  // namespace ljmd
