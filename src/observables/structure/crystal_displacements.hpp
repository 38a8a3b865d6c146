#pragma once

#include <Eigen/Core>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/model/lattice.hpp"

namespace ljmd {

/// A crystal that fills a periodic box: cubic cells, stretched with the edges of the box.
struct CrystalInBox {
    Lattice lattice;
    Index cells;   ///< along x and along y
    Index layers;  ///< cells along z

    [[nodiscard]] Index sites() const { return lattice_atoms(lattice, cells, layers); }

    /// Edges of a cell [sigma].
    [[nodiscard]] Vec3 cell(const Box& box) const;

    /// Distance of nearest neighbours in cubic cells of the same volume [sigma]: a for simple cubic cells of edge a,
    /// a/2^(1/2) for fcc.
    [[nodiscard]] double nearest_neighbours(const Box& box) const;
};

/// Displacements of the atoms of a crystal from its sites.
struct CrystalDisplacements {
    Eigen::Matrix3Xd u;  ///< from the nearest site [sigma], by the order of the atoms in memory; their mean is zero
    Index vacant;        ///< sites that are no atom's nearest one
};

/// Displacements from the nearest sites of a crystal that is placed so that the mean displacement is zero. It starts
/// where the phases of the density at the shortest wave vectors (2 0 0) of fcc, (1 0 0) of simple cubic cells place it,
/// for fcc with the sign of (1 1 1), and is moved by the mean until no atom's nearest site changes. So atoms need no
/// sites of their own, the drift of the whole crystal does not count, and frames of any program will do. Of a fluid the
/// displacements say nothing.
/// @pre the state has a box and atoms
[[nodiscard]] CrystalDisplacements crystal_displacements(const State& state, const CrystalInBox& crystal);

}  // namespace ljmd
