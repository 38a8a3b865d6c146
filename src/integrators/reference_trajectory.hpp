#pragma once

#include <memory>

#include "integrators/operators.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Solution of Newton's equations for a few bodies in unbounded space, nearly to the precision of doubles. The errors
/// of integrators are measured against it.
///
///     dr/dt = v,    dv/dt = f(r) / m
///
/// Method: Runge-Kutta of order 8 with an embedded method that chooses the steps, GSL's rk8pd. Source: Prince and
/// Dormand (1981), doi:10.1016/0771-050X(81)90010-3
class ReferenceTrajectory {
  public:
    /// @param start      begins at start.time
    /// @param force      must outlive this object
    /// @param tolerance  largest error of each position and velocity in one step: tolerance (1 + |value|), in the units
    ///                   of the state; 1e-13 is about the best possible with doubles
    /// @throws ContractViolation if the state has a box or no bodies, or unless 0 < tolerance < 1
    ReferenceTrajectory(const State& start, ForceField& force, double tolerance);
    ~ReferenceTrajectory();
    ReferenceTrajectory(const ReferenceTrajectory&) = delete;
    ReferenceTrajectory(ReferenceTrajectory&&) = delete;
    ReferenceTrajectory& operator=(const ReferenceTrajectory&) = delete;
    ReferenceTrajectory& operator=(ReferenceTrajectory&&) = delete;

    /// Positions and velocities at a time, later or earlier than the last one. The forces are not current. The state is
    /// valid until the next call.
    /// @throws ContractViolation if time is not finite
    /// @throws PhysicsError if the solution ends before that time, for instance by a collision, and says where. Later
    /// calls continue from there.
    const State& advance_to(double time);

    /// The same after a span of time, forwards or backwards. The numbers do not depend on the present time.
    ///
    /// @param within  gets the solution between the present time and the end, in order: at the ends of the method's
    ///                steps, and at seven points within each step that is as long as the tolerance allows, with the
    ///                same accuracy. Cubic interpolation between these points follows the motion.
    /// @throws as advance_to()
    const State& advance_by(double span, const StateWatch& within = {});

    /// Number of accepted steps in all calls.
    [[nodiscard]] Index steps_taken() const;

  private:
    class Integration;
    std::unique_ptr<Integration> integration_;
};

}  // namespace ljmd
