#pragma once

#include <vector>

#include "ljmd/model/state.hpp"

namespace ljmd {

/// Periodic images of the atoms near the walls, as ghosts behind the local atoms of a State.
///
/// With them a pair search needs no minimum image: every neighbour of a local atom within `halo` is a local atom or a
/// ghost, each image an entry of its own. One process exchanges with itself; this is the place where ranks would
/// exchange with each other. Images are taken along x, then of those and the atoms along y, then along z, so that edges
/// and corners come by themselves.
class GhostExchange {
  public:
    /// Make the ghosts: all images inside [-halo, L + halo).
    /// @pre every local atom lies in [0, L); halo > 0
    void create(State& state, double halo);

    /// Move the ghosts to where their atoms are now. Exact: a ghost is its atom plus whole edges.
    /// @pre order and number of atoms unchanged since create()
    void update(State& state) const;

    /// How many ghosts create() made: a state with another number has lost them.
    [[nodiscard]] Index count() const { return static_cast<Index>(images_.size()); }

  private:
    struct Image {
        Index owner;  ///< index of the local atom
        Vec3 shift;   ///< whole edges [sigma]
    };
    std::vector<Image> images_;
};

}  // namespace ljmd
