#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/aligned_vector.hpp"
#include "ljmd/execution/execution.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

class Archive;
class SharedArchive;

/// Views of per-atom vectors: column i is atom i. A view is valid until the next call that may reorder atoms or change
/// their number (ForceField::evaluate, State::reorder, State::set_ghost_count).
using VectorView = Eigen::Map<Eigen::Matrix3Xd, Eigen::Unaligned, Eigen::OuterStride<vector_stride>>;
using ConstVectorView = Eigen::Map<const Eigen::Matrix3Xd, Eigen::Unaligned, Eigen::OuterStride<vector_stride>>;

/// The same with the zero after the three numbers of each column: whole vectors, for computations that keep it zero.
using PaddedView = Eigen::Map<Eigen::Array<double, vector_stride, Eigen::Dynamic>>;
using ConstPaddedView = Eigen::Map<const Eigen::Array<double, vector_stride, Eigen::Dynamic>>;
[[nodiscard]] inline PaddedView padded(VectorView view) {
    return {view.data(), vector_stride, view.cols()};
}
[[nodiscard]] inline ConstPaddedView padded(const ConstVectorView& view) {
    return {view.data(), vector_stride, view.cols()};
}

/// Particles: positions, velocities, forces, masses, ids, and registered per-atom vectors.
///
/// Order is not identity: a neighbour list may reorder atoms in memory at any evaluation of the forces. Each atom has
/// an id, 0 ... N-1; observers and writers go by id. Positions hold the N local atoms first, then the ghosts (periodic
/// images, which belong to the neighbour search and have no other properties).
///
/// Where several ranks share a system (Execution::ranks()), each has a part of the atoms: count() of total(). Loops run
/// over the atoms that are here; sum_over() adds up all ranks' atoms. Ghosts are then atoms of other ranks.
///
/// Fluids are in reduced units: sigma = epsilon = m = k_B = 1. Few-body systems have no box and use the units of their
/// deck.
class State {
  public:
    /// N atoms of mass 1 at the origin, at rest, ids 0 ... N-1. Of several ranks each has an even share of the ids.
    /// @param execution  for all loops over these atoms  @throws ContractViolation if count < 0
    explicit State(Index count, std::optional<Box> box = std::nullopt, Execution execution = {});

    /// Threads and SIMD level that work on these atoms. Not archived: a checkpoint can be read into a state with
    /// others.
    [[nodiscard]] const Execution& execution() const { return execution_; }

    /// Number of the atoms that are here.
    [[nodiscard]] Index count() const { return count_; }
    /// Number of the atoms of all ranks, N.
    [[nodiscard]] Index total() const { return total_; }
    [[nodiscard]] Index ghost_count() const { return ghost_count_; }

    [[nodiscard]] bool has_box() const { return box_.has_value(); }
    /// @throws ContractViolation when the system is unbounded
    [[nodiscard]] const Box& box() const;

    /// Replace the box and scale all positions with it (affinely). Image counts are kept, forces become stale.
    void rescale_to(const Box& box);

    // Read access by index. Shape (3, N) unless said otherwise.
    [[nodiscard]] ConstVectorView positions() const;             ///< [sigma], near the box, see unwrapped()
    [[nodiscard]] ConstVectorView positions_and_ghosts() const;  ///< (3, N + ghosts)
    /// [sigma/tau] @throws ContractViolation while a kick is pending, see kick()
    [[nodiscard]] ConstVectorView velocities() const;
    [[nodiscard]] ConstVectorView forces() const;  ///< [epsilon/sigma]
    [[nodiscard]] const std::vector<double>& masses() const { return masses_; }
    [[nodiscard]] const std::vector<Index>& ids() const { return ids_; }

    /// Write access. Writing positions makes the forces stale; writing positions or velocities ends the integrator's
    /// phase. Positions must lie on the box's grid, see `snapped`.
    [[nodiscard]] VectorView write_positions();
    [[nodiscard]] VectorView write_velocities();
    [[nodiscard]] VectorView write_forces();
    [[nodiscard]] std::vector<double>& write_masses();

    /// v += dt f/m with the present forces. The kick stays pending until finish_kick(), or until velocities are
    /// written or forces, masses or order are about to change, so that a kick that ends a step and the one that begins
    /// the next become one pass over the atoms (take_kick()). Ends the integrator's phase, as writing velocities does.
    /// @pre forces are current
    void kick(double dt);
    /// Apply a pending kick, if there is one.
    void finish_kick();
    /// Take over a pending kick. @return its dt, which the caller has to apply; 0 if no kick is pending
    [[nodiscard]] double take_kick();

    /// r rounded to the grid of the box; r itself without a box.
    [[nodiscard]] Vec3 snapped(const Vec3& r) const { return box_ ? box_->snap(r) : r; }

    /// Adding this number to a coordinate and subtracting it rounds as `snapped` does; 0 without a box.
    [[nodiscard]] double rounding() const { return box_ ? box_->rounding() : 0.0; }

    /// Bring every local atom into [0, L) and count the edges crossed. Exact (see Box::crossings), so forces stay
    /// current.
    /// @throws PhysicsError naming the atom (counted from 1) if its position is not finite or a million edges away
    /// @throws ContractViolation if the system is unbounded
    void wrap();

    /// Position of atom i without periodic wrapping: continuous in time.
    [[nodiscard]] Vec3 unwrapped(Index i) const;

    /// Number of box edges that atom i has crossed: unwrapped = position + image * edges.
    [[nodiscard]] const Eigen::Vector3i& image(Index i) const { return images_[static_cast<std::size_t>(i)]; }
    void set_image(Index i, const Eigen::Vector3i& image) { images_[static_cast<std::size_t>(i)] = image; }

    /// Reorder all per-atom data except stale forces: atom k of the new order is atom order[k] of the old one. Ghosts
    /// are dropped.
    /// @pre order is a permutation of 0 ... N-1
    void reorder(const std::vector<Index>& order);

    /// Send atoms to other ranks, and take in what they send. Atoms that stay keep their order; atoms from other ranks
    /// follow, rank by rank. Ghosts are dropped. Collective.
    /// @param destinations  the rank of each atom here
    void migrate(const std::vector<int>& destinations);

    /// The atoms of all ranks, in the order of the ranks, as a state that is no longer shared: at rank 0. A state
    /// without atoms elsewhere. Collective.
    [[nodiscard]] State gathered() const;

    /// Increases whenever atoms are reordered; tells holders of indices whether these are still valid.
    [[nodiscard]] Index order_version() const { return order_version_; }

    /// Set the number of ghosts after the local atoms; write_ghosts() gives their positions. Forces stay current.
    void set_ghost_count(Index count);
    [[nodiscard]] VectorView write_ghosts();

    /// index_of()[id] is the index of the atom with that id. @pre the state is not shared (ContractViolation)
    [[nodiscard]] std::vector<Index> index_of() const;

    /// Register a per-atom vector that is reordered with the atoms, such as the half-step velocities of an integrator.
    /// A second call with the same name returns the same handle. Starts as zeros.
    [[nodiscard]] std::size_t register_vectors(const std::string& name);
    [[nodiscard]] VectorView registered(std::size_t handle);
    [[nodiscard]] ConstVectorView registered(std::size_t handle) const;

    /// Whose data the registered vectors hold: the integrator of the last step, and its number of steps, which gives
    /// its place in a cycle. Anybody else who writes positions or velocities ends the phase; the integrator then starts
    /// up again.
    struct Phase {
        std::string integrator;  ///< method with its settings; empty: none
        Index steps = 0;         ///< steps since its start-up

        void archive(Archive& a);
    };
    [[nodiscard]] const Phase& phase() const { return phase_; }
    void set_phase(Phase phase) { phase_ = std::move(phase); }

    /// True if the forces belong to the present positions.
    [[nodiscard]] bool forces_are_current() const { return forces_current_; }
    void mark_forces_current() { forces_current_ = true; }

    /// Everything except ghosts, in the order of the atoms in memory. Of several ranks rank 0 writes the atoms of all,
    /// and the others nothing; each reads all, and keeps an even share in the order of the archive. Collective.
    /// @throws CheckpointError for another number of atoms, another box, or values that no state can have
    void archive(Archive& a);

    double time = 0.0;  ///< [tau]
    Index step = 0;     ///< number of steps since the start of the run

    /// Variables of the stage's thermostat; empty without one. The first one is heat().
    std::vector<double> bath;

    /// Energy that the thermostat has given to the atoms since the stage began [epsilon]. The total energy minus this
    /// heat is conserved, but for errors of the integrator.
    [[nodiscard]] double heat() const { return bath.empty() ? 0.0 : bath.front(); }

  private:
    struct Registered {
        std::string name;
        AlignedVector<double> data;
    };

    /// Room for one per-atom vector while atoms are reordered. It is kept, because fresh memory costs more than the
    /// copies. A copy of a state begins without.
    struct Spare {
        AlignedVector<double> room;

        Spare() = default;
        Spare(const Spare& /*other*/) {}
        Spare(Spare&&) = default;
        Spare& operator=(const Spare& /*other*/) { return *this; }
        Spare& operator=(Spare&&) = default;
        ~Spare() = default;
    };

    /// Length of the numbers of an atom, see pack().
    [[nodiscard]] std::size_t packed_size() const;
    /// Append all that belongs to an atom to `numbers`.
    void pack(Index atom, std::vector<double>& numbers) const;
    /// The inverse. @return the end of what was read
    const double* unpack(Index atom, const double* numbers);
    /// Change the number of atoms here; new ones are yet to be set. Drops ghosts.
    void resize(Index count);
    /// Give back memory that a former, larger number of atoms took.
    void give_back_room();
    /// The rest of archive(), for reading.
    void read(Archive& a, SharedArchive& atoms);

    Execution execution_;
    Index total_;
    Index count_;
    Index ghost_count_ = 0;
    Index order_version_ = 0;
    std::optional<Box> box_;
    AlignedVector<double> positions_;  // x y z and zero of each atom, see vector_stride
    AlignedVector<double> velocities_;
    double kick_due_ = 0.0;
    AlignedVector<double> forces_;
    std::vector<double> masses_;
    std::vector<Index> ids_;
    std::vector<Eigen::Vector3i> images_;
    std::vector<Registered> registered_;
    Spare spare_;
    bool forces_current_ = false;
    Phase phase_;
};

}  // namespace ljmd
