#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// Crystal lattices of cubic cells.
enum class Lattice { fcc, simple_cubic };

/// "fcc", "simple-cubic"
[[nodiscard]] std::vector<std::string> lattice_names();

/// @throws InputError for another name
[[nodiscard]] Lattice find_lattice(const std::string& name);

/// Sites per cubic cell: 4 for fcc, 1 for simple cubic.
[[nodiscard]] Index sites_per_cell(Lattice lattice);

/// Number of atoms in cells x cells x layers cubic cells.
/// @throws InputError unless 0 <= cells, layers <= 2^20 (2^62 atoms of fcc)
[[nodiscard]] Index lattice_atoms(Lattice lattice, Index cells, Index layers);

/// Number of atoms in cells^3 cubic cells. @throws InputError as above
[[nodiscard]] Index lattice_atoms(Lattice lattice, Index cells);

/// Numbers of cells along an edge whose crystals are nearest to `atoms` from below and from above. They are equal if
/// and only if `atoms` fits exactly. The smallest number is one cell, also for fewer atoms than it holds.
/// @pre 0 <= atoms <= 2^48, beyond which the cube root is not exact enough
struct NearestCells {
    Index below;  ///< at least 1
    Index above;
};
[[nodiscard]] NearestCells nearest_cells(Lattice lattice, Index atoms);

/// Edge of a cubic box of N atoms at number density rho: L = (N / rho)^(1/3).
/// @param density  [sigma^-3]
/// @pre atoms > 0, density > 0
[[nodiscard]] Box cubic_box(Index atoms, double density);

/// Edges of a crystal of cells x cells x layers cubic cells at a number density [sigma].
/// @param density  [sigma^-3]
/// @pre cells, layers > 0, density > 0
[[nodiscard]] Vec3 crystal_edges(Lattice lattice, Index cells, Index layers, double density);

/// A site of cells x cells x layers cubic cells; site 0 lies at the origin.
/// @param edges  of the crystal [sigma], at most the box's
/// @param box    on whose grid the sites lie
/// @return position [sigma] inside the box
[[nodiscard]] Vec3 lattice_site(Lattice lattice, Index cells, Index layers, const Vec3& edges, const Box& box,
                                Index site);

/// All sites, as lattice_site() has them.
[[nodiscard]] std::vector<Vec3> lattice_sites(Lattice lattice, Index cells, Index layers, const Vec3& edges,
                                              const Box& box);

/// Sites of cells^3 cubic cells that fill the box.
/// @param cells  number of cells along each edge, at least 1
[[nodiscard]] std::vector<Vec3> lattice_sites(Lattice lattice, Index cells, const Box& box);

/// A position drawn uniformly in the box. It depends on box, seed and atom id only.
[[nodiscard]] Vec3 random_position(const Box& box, std::uint64_t seed, Index id);

/// Such positions of the atoms 0 to N - 1; atoms may overlap.
[[nodiscard]] std::vector<Vec3> random_positions(Index atoms, const Box& box, std::uint64_t seed);

}  // namespace ljmd
