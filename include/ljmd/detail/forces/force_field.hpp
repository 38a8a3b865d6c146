#pragma once

#include <optional>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// What an evaluation computes. Forces are always computed.
struct Request {
    bool energy = false;             ///< also potential energy and virial
    bool order_independent = false;  ///< forces do not depend, to the last bit, on the order of the atoms in memory

    static const Request forces;
    static const Request forces_and_energy;
    friend constexpr bool operator==(const Request&, const Request&) = default;
};
inline constexpr Request Request::forces{};
inline constexpr Request Request::forces_and_energy{.energy = true};

/// Results of an evaluation besides forces; zeros if only forces were requested.
struct Evaluation {
    double potential_energy = 0.0;  ///< U [epsilon], without tail correction
    Mat3 virial = Mat3::Zero();     ///< W_ab = sum over pairs of r_a f_b [epsilon]; its trace is the scalar virial
    std::optional<double> external_energy = {};  ///< of an external force that has one (ExternalForce) [epsilon]
};

/// Forces on particles. This is all that integrators know of the physics.
class ForceField {
  public:
    virtual ~ForceField() = default;

    /// Compute the forces at the present positions. May wrap atoms into the box and reorder them in memory.
    /// @post state.forces_are_current()
    /// @throws PhysicsError when a position is not finite
    Evaluation evaluate(State& state, Request request) {
        const Evaluation evaluation = compute(state, request);
        state.mark_forces_current();
        return evaluation;
    }

    /// Read or write what a later evaluation depends on.
    /// @param state  as the last evaluation left it, except that positions may have moved; is not changed, but that
    /// its atoms pass from rank to rank where several share it
    /// @throws CheckpointError
    virtual void archive(Archive& /*a*/, State& /*state*/) {}

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
