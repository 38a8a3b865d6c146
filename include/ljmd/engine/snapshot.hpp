#pragma once

#include <Eigen/Core>
#include <optional>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"

namespace ljmd {

/// A configuration during a run, by atom: column i of a matrix belongs to the atom with id i, whatever the order in
/// memory. Matrices have the shape (3, N); each is put together when it is asked for first, and stays valid as long as
/// the snapshot, which lasts for one call of Observer::sample.
class Snapshot {
  public:
    /// @param evaluation  at the positions of the state, with energy; nothing: energy and pressure are not known
    /// @pre the state outlives the snapshot and does not change meanwhile
    Snapshot(const State& state, const TailCorrection& tail, std::optional<Evaluation> evaluation);

    [[nodiscard]] Index step() const { return state_.step; }
    [[nodiscard]] double time() const { return state_.time; }  ///< [tau]
    [[nodiscard]] Index atoms() const { return state_.count(); }
    [[nodiscard]] Vec3 edges() const { return state_.box().edges(); }  ///< of the box [sigma]

    [[nodiscard]] const Eigen::Matrix3Xd& positions() const;   ///< in the box, 0 <= x < L [sigma]
    [[nodiscard]] const Eigen::Matrix3Xd& unwrapped() const;   ///< continuous in time [sigma]
    [[nodiscard]] const Eigen::Matrix3Xd& velocities() const;  ///< [sigma/tau]
    [[nodiscard]] const Eigen::Matrix3Xd& forces() const;      ///< [epsilon/sigma]

    /// Energies per atom, temperature, pressure. @throws InputError unless Observer::needs_energy()
    [[nodiscard]] const Thermodynamics& thermodynamics() const;

  private:
    template <class Column>
    const Eigen::Matrix3Xd& by_id(std::optional<Eigen::Matrix3Xd>& kept, const Column& column) const;

    const State& state_;
    const TailCorrection& tail_;
    std::optional<Evaluation> evaluation_;
    mutable std::optional<Eigen::Matrix3Xd> positions_;
    mutable std::optional<Eigen::Matrix3Xd> unwrapped_;
    mutable std::optional<Eigen::Matrix3Xd> velocities_;
    mutable std::optional<Eigen::Matrix3Xd> forces_;
    mutable std::optional<Thermodynamics> thermodynamics_;
};

}  // namespace ljmd
