#pragma once

#include <functional>
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
struct Evaluate {
    bool order_independent = false;  ///< see Request
};

/// What only one integrator does to positions, velocities and the vectors it has registered; written in its own file.
/// @pre forces current
struct Update {
    std::function<void(State&)> apply;
};

/// Change velocities at a time when forces may be stale, as a thermostat does half-way of a drift.
struct Thermalise {
    std::function<void(State&)> apply;
};

/// Advance by a method that evaluates the forces as often as it needs. Leaves them stale.
struct Solve {
    std::function<void(State&, ForceField&)> advance;
};

/// An integrator is a list of these. A backend may fuse neighbouring ones.
using Operator = std::variant<Kick, Drift, Evaluate, Update, Thermalise, Solve>;

/// Apply the operators of one step in order.
///
/// Shapes: positions, velocities, forces (3, N) [sigma, sigma/tau, epsilon/sigma]; masses (N) [m].
/// @param request  whether the last Evaluate of the list is asked for the energy too
/// @return what the last Evaluate returned
/// @throws ContractViolation when a Kick or an Update meets stale forces
Evaluation apply(const std::vector<Operator>& operators, State& state, ForceField& force_field, Request request);

}  // namespace ljmd
