#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/core/aligned_vector.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

class Archive;

/// Views of per-atom vectors: column i is atom i. The layout behind them is private to State and may change; use
/// `view.col(i)`. A view is valid until the next call that may reorder atoms or change their number
/// (ForceField::evaluate, State::reorder, State::set_ghosts).
/// Column i begins at a multiple of 32 bytes; the number behind its three is zero and may be computed with, for the
/// sake of whole vectors, as long as it stays zero.
using VectorView = Eigen::Map<Eigen::Matrix3Xd, Eigen::Unaligned, Eigen::OuterStride<4>>;
using ConstVectorView = Eigen::Map<const Eigen::Matrix3Xd, Eigen::Unaligned, Eigen::OuterStride<4>>;

/// Particles: positions, velocities, forces, masses, ids, and what else is registered per atom.
///
/// Order is not identity: a neighbour list may rearrange atoms in memory at any evaluation of the forces. Each atom
/// carries an id, 0 ... N-1; observers and writers go by id. Positions hold the N local atoms first, then ghosts
/// (periodic images, which belong to the neighbour search and have no other properties).
///
/// Fluids are in reduced units: sigma = epsilon = m = k_B = 1. Few-body systems have no box and their deck's units.
class State {
  public:
    /// N atoms of mass 1 at the origin, at rest, ids 0 ... N-1. @throws ContractViolation if count < 0
    explicit State(Index count, std::optional<Box> box = std::nullopt);

    [[nodiscard]] Index count() const { return count_; }
    [[nodiscard]] Index ghost_count() const { return ghost_count_; }

    [[nodiscard]] bool has_box() const { return box_.has_value(); }
    /// @throws ContractViolation when the system is unbounded
    [[nodiscard]] const Box& box() const;

    /// Replace the box and scale all positions with it (affine); images are kept. Forces become stale.
    void rescale_to(const Box& box);

    // Read access: (3, N), by index.
    [[nodiscard]] ConstVectorView positions() const;             ///< [sigma], near the box, see unwrapped()
    [[nodiscard]] ConstVectorView positions_and_ghosts() const;  ///< (3, N + ghosts)
    [[nodiscard]] ConstVectorView velocities() const;            ///< [sigma/tau], see kick()
    [[nodiscard]] ConstVectorView forces() const;                ///< [epsilon/sigma]
    [[nodiscard]] const std::vector<double>& masses() const { return masses_; }
    [[nodiscard]] const std::vector<Index>& ids() const { return ids_; }

    /// Write access to positions makes the forces stale, to positions or velocities ends the integrator's phase.
    /// Positions written must be on the box's grid: pass them through `snapped`.
    [[nodiscard]] VectorView write_positions();
    [[nodiscard]] VectorView write_velocities();
    [[nodiscard]] VectorView write_forces();
    [[nodiscard]] std::vector<double>& write_masses();

    /// v += dt f/m with the forces there are. It is done when velocities are asked for, or what it depends on is about
    /// to change, unless take_kick() comes first: a kick that ends a step and the one that begins the next are then one
    /// pass over the atoms. So velocities() may write: after a kick its first call must not be one of several threads.
    /// Ends the integrator's phase, as writing velocities does.
    /// @pre forces are current
    void kick(double dt);
    /// @return dt of a kick that is not done yet, which the caller does; 0 if there is none
    [[nodiscard]] double take_kick();

    /// r on the grid of the box; r itself when there is no box.
    [[nodiscard]] Vec3 snapped(const Vec3& r) const { return box_ ? box_->snap(r) : r; }

    /// Adding this to a coordinate and taking it away again is what `snapped` does; 0 without a box.
    [[nodiscard]] double rounding() const { return box_ ? box_->rounding() : 0.0; }

    /// Bring every local atom into [0, L), counting the edges crossed. Exact (see Box::crossings), so forces stay
    /// current.
    /// @throws PhysicsError naming the atom (counted from 1) when one is not finite or a million edges away
    /// @throws ContractViolation when the system is unbounded
    void wrap();

    /// Position of atom i as if the box had no walls: continuous in time.
    [[nodiscard]] Vec3 unwrapped(Index i) const;

    /// Number of edges that atom i has crossed: unwrapped = position + image * edges.
    [[nodiscard]] const Eigen::Vector3i& image(Index i) const { return images_[static_cast<std::size_t>(i)]; }
    void set_image(Index i, const Eigen::Vector3i& image) { images_[static_cast<std::size_t>(i)] = image; }

    /// Rearrange all per-atom data, stale forces excepted: atom k of the new order is atom order[k] of the old. Ghosts
    /// are dropped.
    /// @pre order is a permutation of 0 ... N-1
    void reorder(const std::vector<Index>& order);

    /// Counts the calls of reorder(): whoever keeps indices can tell that they are old.
    [[nodiscard]] Index order_version() const { return order_version_; }

    /// Set the periodic images that follow the local atoms: `ghosts.col(k)`. Forces stay current.
    void set_ghost_count(Index count);
    [[nodiscard]] VectorView write_ghosts();

    /// index_of()[id] is where that atom lies now.
    [[nodiscard]] std::vector<Index> index_of() const;

    /// Register a per-atom vector that must be sorted with the atoms (previous positions of a multistep integrator).
    /// Calling again with the same name returns the same handle. Starts as zeros.
    [[nodiscard]] std::size_t register_vectors(const std::string& name);
    [[nodiscard]] VectorView registered(std::size_t handle);
    [[nodiscard]] ConstVectorView registered(std::size_t handle) const;

    /// What the integrator of the last step has left in the registered vectors, and how far it is in its cycle of
    /// steps. Whoever else writes positions or velocities ends it: the integrator then begins anew from them.
    struct Phase {
        std::string integrator;  ///< which one, with its settings; empty: none
        Index steps = 0;         ///< since it began

        void archive(Archive& a);
    };
    [[nodiscard]] const Phase& phase() const { return phase_; }
    void set_phase(Phase phase) { phase_ = std::move(phase); }

    /// Forces belong to the present positions.
    [[nodiscard]] bool forces_are_current() const { return forces_current_; }
    void mark_forces_current() { forces_current_ = true; }

    /// All of it but the ghosts, in the order in which the atoms lie.
    /// @throws CheckpointError  a state of another number of atoms or another box, or what cannot be a state
    void archive(Archive& a);

    double time = 0.0;  ///< [tau]
    Index step = 0;     ///< steps since the start of the run

    /// What the thermostat of the stage keeps from one step to the next; empty without one. The first number is heat().
    std::vector<double> bath;

    /// Energy that the thermostat has given to the atoms since the stage began [epsilon]. What the total energy is
    /// above it, is conserved as well as the integrator does it.
    [[nodiscard]] double heat() const { return bath.empty() ? 0.0 : bath.front(); }

  private:
    void do_kick() const;

    struct Registered {
        std::string name;
        AlignedVector<double> data;

        void archive(Archive& a);
    };

    Index count_;
    Index ghost_count_ = 0;
    Index order_version_ = 0;
    std::optional<Box> box_;
    AlignedVector<double> positions_;           // 4 doubles an atom: x y z and padding
    mutable AlignedVector<double> velocities_;  // what a kick that is due does to them is no change
    mutable double kick_due_ = 0.0;
    AlignedVector<double> forces_;
    std::vector<double> masses_;
    std::vector<Index> ids_;
    std::vector<Eigen::Vector3i> images_;
    std::vector<Registered> registered_;
    bool forces_current_ = false;
    Phase phase_;
};

}  // namespace ljmd
