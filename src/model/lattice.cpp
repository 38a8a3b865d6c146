#include "ljmd/model/lattice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/elementary.hpp"
#include "ljmd/detail/options/registry.hpp"

namespace ljmd {

namespace {

struct NamedLattice {
    std::string name;
    Lattice lattice;
};

const std::vector<NamedLattice>& all_lattices() {
    static const std::vector<NamedLattice> all{{"fcc", Lattice::fcc}, {"simple-cubic", Lattice::simple_cubic}};
    return all;
}

/// Sites in units of the edge of the cubic cell.
const std::vector<Vec3>& basis(Lattice lattice) {
    static const std::vector<Vec3> fcc{{0.0, 0.0, 0.0}, {0.5, 0.5, 0.0}, {0.5, 0.0, 0.5}, {0.0, 0.5, 0.5}};
    static const std::vector<Vec3> simple_cubic{{0.0, 0.0, 0.0}};
    return lattice == Lattice::fcc ? fcc : simple_cubic;
}

}  // namespace

std::vector<std::string> lattice_names() {
    return plugin_names(all_lattices());
}

Lattice find_lattice(const std::string& name) {
    return find_plugin(all_lattices(), name, "lattice").lattice;
}

Index sites_per_cell(Lattice lattice) {
    return static_cast<Index>(basis(lattice).size());
}

Index lattice_atoms(Lattice lattice, Index cells, Index layers) {
    constexpr Index max_cells = Index{1} << 20;  // 4 * 2^60 sites fit into an Index
    for (const Index along_edge : {cells, layers}) {
        if (along_edge < 0 || along_edge > max_cells) {
            throw InputError(
                fmt::format("a crystal of {} cells along an edge: allowed are 0 to {}", along_edge, max_cells));
        }
    }
    return sites_per_cell(lattice) * cells * cells * layers;
}

Index lattice_atoms(Lattice lattice, Index cells) {
    return lattice_atoms(lattice, cells, cells);
}

NearestCells nearest_cells(Lattice lattice, Index atoms) {
    const double exact = cube_root(static_cast<double>(atoms) / static_cast<double>(sites_per_cell(lattice)));
    Index below = std::max<Index>(1, static_cast<Index>(std::floor(exact)));
    while (lattice_atoms(lattice, below + 1) <= atoms) {  // the root may round below a whole number
        ++below;
    }
    return {below, lattice_atoms(lattice, below) == atoms ? below : below + 1};
}

Box cubic_box(Index atoms, double density) {
    return Box(Vec3::Constant(cube_root(static_cast<double>(atoms) / density)));
}

Vec3 crystal_edges(Lattice lattice, Index cells, Index layers, double density) {
    const double edge = cubic_box(lattice_atoms(lattice, cells), density).shortest_edge();
    return {edge, edge, edge * (static_cast<double>(layers) / static_cast<double>(cells))};
}

Vec3 lattice_site(Lattice lattice, Index cells, Index layers, const Vec3& edges, const Box& box, Index site) {
    const std::vector<Vec3>& sites = basis(lattice);
    const Vec3 cell = edges.cwiseQuotient(Eigen::Matrix<Index, 3, 1>(cells, cells, layers).cast<double>());
    const Index number = site / std::ssize(sites);
    const Eigen::Matrix<Index, 3, 1> corner(number % cells, number / cells % cells, number / cells / cells);
    const Vec3 place = corner.cast<double>() + sites[static_cast<std::size_t>(site % std::ssize(sites))];
    return box.snap(place.cwiseProduct(cell));
}

std::vector<Vec3> lattice_sites(Lattice lattice, Index cells, Index layers, const Vec3& edges, const Box& box) {
    std::vector<Vec3> sites(static_cast<std::size_t>(lattice_atoms(lattice, cells, layers)));
    for (std::size_t k = 0; k < sites.size(); ++k) {
        sites[k] = lattice_site(lattice, cells, layers, edges, box, static_cast<Index>(k));
    }
    return sites;
}

std::vector<Vec3> lattice_sites(Lattice lattice, Index cells, const Box& box) {
    return lattice_sites(lattice, cells, cells, box.edges(), box);
}

Vec3 random_position(const Box& box, std::uint64_t seed, Index id) {
    const Vec3 r = box.snap(Random(seed, RandomStream::positions).uniform(0, id).cwiseProduct(box.edges()));
    return r - box.crossings(r).cwiseProduct(box.edges());
}

std::vector<Vec3> random_positions(Index atoms, const Box& box, std::uint64_t seed) {
    std::vector<Vec3> positions(static_cast<std::size_t>(atoms));
    for (std::size_t k = 0; k < positions.size(); ++k) {
        positions[k] = random_position(box, seed, static_cast<Index>(k));
    }
    return positions;
}

}  // namespace ljmd
