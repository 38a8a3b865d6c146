#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// Looks at states that a method goes through within a time step. It sees them in order, their times are true, and
/// their forces need not be current.
using StateWatch = std::function<void(const State&)>;

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

/// Advance by a method that evaluates the forces as often as it needs, in steps of its own. Leaves the forces stale.
struct Solve {
    /// @param within  may be empty; changes no bit of what comes out
    std::function<void(State&, ForceField&, const StateWatch& within)> advance;
};

/// An integrator is a list of these. A backend may fuse neighbouring ones.
using Operator = std::variant<Kick, Drift, Evaluate, Update, Thermalise, Solve>;

/// Apply the operators of one step in order.
///
/// Shapes: positions, velocities, forces (3, N) [sigma, sigma/tau, epsilon/sigma]; masses (N) [m].
/// @param request  whether the last Evaluate of the list is asked for the energy too
/// @param within   sees what a Solve goes through
/// @return what the last Evaluate returned
/// @throws ContractViolation when a Kick or an Update meets stale forces
Evaluation apply(const std::vector<Operator>& operators, State& state, ForceField& force_field, Request request,
                 const StateWatch& within = {});

}  // namespace ljmd
