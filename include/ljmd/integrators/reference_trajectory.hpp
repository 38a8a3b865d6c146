#pragma once

#include <memory>

#include "ljmd/forces/force_field.hpp"
#include "ljmd/integrators/operators.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// The solution of Newton's equations for a few bodies in unbounded space to nearly the precision of doubles, to
/// measure the errors of integrators by.
///
///     dr/dt = v,    dv/dt = f(r) / m
///
/// Solved by a Runge-Kutta method of order 8 with an embedded one that chooses the steps, GSL's rk8pd. Source: Prince
/// and Dormand (1981), doi:10.1016/0771-050X(81)90010-3
class ReferenceTrajectory {
  public:
    /// @param start      begins at start.time
    /// @param force      must outlive this object
    /// @param tolerance  largest error of each position and velocity made in one step: tolerance (1 + |value|), in the
    ///                   units of the state; 1e-13 is about the best that doubles give
    /// @throws ContractViolation when the state has a box or no bodies, or unless 0 < tolerance < 1
    ReferenceTrajectory(const State& start, ForceField& force, double tolerance);
    ~ReferenceTrajectory();
    ReferenceTrajectory(const ReferenceTrajectory&) = delete;
    ReferenceTrajectory(ReferenceTrajectory&&) = delete;
    ReferenceTrajectory& operator=(const ReferenceTrajectory&) = delete;
    ReferenceTrajectory& operator=(ReferenceTrajectory&&) = delete;

    /// Positions and velocities at a time, later or earlier than the last one asked for. Its forces are not current; it
    /// is valid until the next call.
    /// @throws ContractViolation when time is not finite
    /// @throws PhysicsError when the solution ends before, as when bodies collide; says where. Later calls go on from
    ///         there.
    const State& advance_to(double time);

    /// The same after a span of time, later or earlier by it; the numbers do not depend on what the time is now.
    ///
    /// @param within  sees the solution between now and then, in order: at the ends of the steps that the method takes,
    /// and
    ///                at seven places inside of those that are as long as the tolerance allows, where the solution is
    ///                as exact as at the ends. Cubic polynomials from one to the next follow the motion.
    /// @throws  as advance_to()
    const State& advance_by(double span, const StateWatch& within = {});

    /// Steps of all calls together, without those that were tried and found too long.
    [[nodiscard]] Index steps_taken() const;

  private:
    class Integration;
    std::unique_ptr<Integration> integration_;
};

}  // namespace ljmd
