#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Where the atoms are at one evaluation of the forces, by atom: column i of a matrix belongs to the atom with id i,
/// whatever the order in memory. Matrices have the shape (3, N); each is put together when it is asked for first.
class AtomPositions {
  public:
    /// From now on the atoms of this state. @pre it outlives the calls of the other functions and does not change
    void look_at(const State& state);

    [[nodiscard]] double time() const { return state_->time; }  ///< that the positions belong to [tau]
    [[nodiscard]] Index atoms() const { return state_->count(); }
    [[nodiscard]] Vec3 edges() const { return state_->box().edges(); }  ///< of the box [sigma]

    [[nodiscard]] const Eigen::Matrix3Xd& positions() const;  ///< in the box, 0 <= x < L [sigma]
    [[nodiscard]] const Eigen::Matrix3Xd& unwrapped() const;  ///< continuous in time [sigma]

  private:
    const State* state_ = nullptr;
    mutable Eigen::Matrix3Xd positions_;
    mutable Eigen::Matrix3Xd unwrapped_;
    mutable bool positions_known_ = false;
    mutable bool unwrapped_known_ = false;
};

/// What an external force returns beside the forces. Unused is what it does not have.
struct ExternalEnergy {
    double energy = 0.0;         ///< U_ext of all atoms together [epsilon]
    Mat3 virial = Mat3::Zero();  ///< W_ab, see ExternalForce::has_virial() [epsilon]
};

/// A force on each atom of a fluid from outside, by the user of the engine, in addition to the pair forces: a trap, a
/// field, a wall, a drive. FluidSpec::external has it.
///
/// It is called once for each evaluation of the forces, in the thread that takes the steps. That may be several times
/// a step, or at other times than the steps', as the integrator has it. So the forces must depend on nothing but the
/// positions and the time: no memory, no random numbers. Then a run has the same bits whatever the number of threads,
/// and whether or not it was interrupted. What it throws ends the run.
class ExternalForce {
  public:
    virtual ~ExternalForce() = default;

    /// For messages, and for the record of a run: 1 to 64 printable characters.
    [[nodiscard]] virtual std::string name() const = 0;

    /// Whether it has a potential energy: f = -grad U_ext(r), and U_ext does not depend on time. Then the total energy
    /// includes U_ext and is conserved. Without one the total energy belongs to atoms on which work is done.
    [[nodiscard]] virtual bool has_energy() const { return true; }

    /// Whether it tells its part of the virial, W_ab = -dU_ext/d(eps_ab) when box and positions are stretched by 1 +
    /// eps together. It is added to the pairs' virial, and so to the pressure. It is 0 for a field that scales with the
    /// box, as U_0 cos(2 pi x/L). A barostat needs it.
    [[nodiscard]] virtual bool has_virial() const { return false; }

    /// Compute the forces at these positions.
    /// @param energy  whether energy and virial are wanted; if not they are ignored
    /// @param forces  zeros of shape (3, N), to be filled in: column i is the force on the atom with id i
    /// [epsilon/sigma]
    virtual ExternalEnergy compute(const AtomPositions& atoms, bool energy, Eigen::Matrix3Xd& forces) = 0;

  protected:
    ExternalForce() = default;
    ExternalForce(const ExternalForce&) = default;
    ExternalForce& operator=(const ExternalForce&) = default;
};

/// Write which external force there is, or read which one there was: a checkpoint cannot hold the force itself.
/// @param force  null: none  @throws CheckpointError  another name, or an energy that one has and the other has not
void archive_presence(Archive& a, const ExternalForce* force);

/// Adds an external force to the pair forces of a fluid.
class ExternalForceTerm {
  public:
    /// @pre there is a force
    explicit ExternalForceTerm(std::shared_ptr<ExternalForce> force) : force_(std::move(force)) {}

    [[nodiscard]] const std::shared_ptr<ExternalForce>& force() const { return force_; }

    /// Add it to the forces of the state, and energy and virial to the evaluation if the request has them.
    /// @throws PhysicsError naming the atom (counted from 1) if a force is not finite; likewise for energy and virial
    /// @throws InputError if the shape of the forces was changed
    void add(State& state, Request request, Evaluation& evaluation);

    /// Whether the forces of the last evaluation differ between atoms. If not they move the centre of mass and nothing
    /// else.
    [[nodiscard]] bool differs() const { return differs_; }

  private:
    std::shared_ptr<ExternalForce> force_;
    bool differs_ = false;
    AtomPositions atoms_;
    Eigen::Matrix3Xd forces_;
};

}  // namespace ljmd
