#pragma once

#include "ljmd/core/types.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// What an evaluation is asked for. Forces are always computed.
struct Request {
    bool energy = false;             ///< potential energy and virial too
    bool order_independent = false;  ///< each force is the same to the last bit however the atoms lie in memory

    static const Request forces;
    static const Request forces_and_energy;
    friend constexpr bool operator==(const Request&, const Request&) = default;
};
inline constexpr Request Request::forces{};
inline constexpr Request Request::forces_and_energy{.energy = true};

/// What an evaluation returns; zeros when only forces were asked for.
struct Evaluation {
    double potential_energy = 0.0;  ///< U [epsilon], without tail
    Mat3 virial = Mat3::Zero();     ///< W_ab = sum over pairs of r_a f_b [epsilon]; its trace is the scalar virial
};

/// Forces on particles. Integrators know nothing more of the physics than this.
class ForceField {
  public:
    virtual ~ForceField() = default;

    /// Compute the forces at the present positions. May wrap atoms into their box and rearrange them in memory.
    /// @post state.forces_are_current()
    /// @throws PhysicsError when a position is not finite
    Evaluation evaluate(State& state, Request request) {
        const Evaluation evaluation = compute(state, request);
        state.mark_forces_current();
        return evaluation;
    }

    /// What an evaluation leaves to the next one.
    /// @param state  as the last evaluation left it, but for positions that have moved since; is not changed
    /// @throws CheckpointError
    virtual void archive(Archive& /*a*/, const State& /*state*/) {}

  protected:
    ForceField() = default;
    ForceField(const ForceField&) = default;
    ForceField(ForceField&&) = default;
    ForceField& operator=(const ForceField&) = default;
    ForceField& operator=(ForceField&&) = default;

  private:
    virtual Evaluation compute(State& state, Request request) = 0;
};

}  // namespace ljmd
