#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Observer of the states within a time step. It gets them in order, with their true times; their forces need not be
/// current.
using StateWatch = std::function<void(const State&)>;

/// v += (dt/m) f. @pre forces current
struct Kick {
    double dt;  ///< [tau]
};

/// r += dt v, rounded to the grid of the box. Makes the forces stale.
struct Drift {
    double dt;  ///< [tau]
};

/// Compute the forces at the present positions.
struct Evaluate {
    bool order_independent = false;  ///< see Request
};

/// A change of positions, velocities and registered vectors that belongs to one integrator and is written in its file.
/// @pre forces current
struct Update {
    std::function<void(State&)> apply;
    double moves = 0.0;  ///< time by which it moves the positions on [tau]
};

/// A change of velocities while forces may be stale, such as a thermostat's in the middle of a drift.
struct Thermalise {
    std::function<void(State&)> apply;
};

/// Advance by a method with steps of its own, which evaluates the forces as often as it needs. Leaves the forces stale.
struct Solve {
    /// @param within  may be empty; does not change the result
    std::function<void(State&, ForceField&, const StateWatch& within)> advance;
};

/// An integrator is a list of operators. A backend may fuse neighbouring ones.
using Operator = std::variant<Kick, Drift, Evaluate, Update, Thermalise, Solve>;

/// Apply the operators of one step in order.
///
/// Shapes: positions, velocities, forces (3, N) [sigma, sigma/tau, epsilon/sigma]; masses (N) [m].
/// @param request  whether the last Evaluate of the list also computes the energy
/// @param within   gets the states within a Solve
/// At each evaluation state.time is the time of the positions, for forces that depend on it. In the end it is what it
/// was before: whoever takes the step sets it.
/// @return result of the last Evaluate
/// @throws ContractViolation if a Kick or an Update meets stale forces
Evaluation apply(const std::vector<Operator>& operators, State& state, ForceField& force_field, Request request,
                 const StateWatch& within = {});

}  // namespace ljmd
