#pragma once

#include <functional>
#include <vector>

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// What is wanted of atoms beside their ids.
struct AtomParts {
    bool positions = false;
    bool velocities = false;
    bool forces = false;
    bool masses = false;
};

/// Atoms with consecutive ids. Lists that were not asked for are empty.
struct AtomPiece {
    Index first = 0;  ///< id of the first of them
    Index count = 0;
    std::vector<Vec3> positions;          ///< near the box, as State::positions()
    std::vector<Eigen::Vector3i> images;  ///< see State::image(); with the positions
    std::vector<Vec3> velocities;
    std::vector<Vec3> forces;
    std::vector<double> masses;

    /// Positions without periodic wrapping, in the box of the state. See State::unwrapped().
    [[nodiscard]] std::vector<Vec3> unwrapped(const State& state) const;
};

/// Number of atoms of a piece where nobody asks for another: below a megabyte.
inline constexpr Index default_piece = 1 << 12;

/// Pass on all atoms of a state in the order of ids, piece by piece, so that whoever writes them needs no room for all.
/// Where the state is shared among ranks, rank 0 alone calls this, in look_by_id(): the others send.
/// @param atoms_of_piece  of each piece but the last
void visit_by_id(const State& state, const AtomParts& parts, const std::function<void(const AtomPiece&)>& look,
                 Index atoms_of_piece = default_piece);

/// The atoms of all ranks as a state that is not shared, see State::gathered(). Also for rank 0 in look_by_id() alone.
[[nodiscard]] State gathered_for_root(const State& state);

/// Call look() at rank 0, which may call visit_by_id() and gathered_for_root() as often as it likes, while the other
/// ranks give what is asked for. Collective.
void look_by_id(const State& state, const std::function<void()>& look);

}  // namespace ljmd
