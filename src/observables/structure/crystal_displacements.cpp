#include "observables/structure/crystal_displacements.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "execution/loops.hpp"

namespace ljmd {

namespace {

constexpr int most_moves = 20;   // of the crystal; sound ones need one or two
constexpr double still = 1e-12;  // mean displacement, in edges of a cell
using Whole = Eigen::Matrix<Index, 3, 1>;

/// Points of a simple cubic grid along an edge of a cell. Sites of fcc are those of its points whose sum is even.
Index points_per_cell(Lattice lattice) {
    return lattice == Lattice::fcc ? 2 : 1;
}

/// The site nearest to y, in grid points. That of fcc: if the sum of the nearest grid point is odd, the coordinate that
/// was rounded most goes the other way (Conway and Sloane 1982, doi:10.1109/TIT.1982.1056484).
Whole nearest_site(Lattice lattice, const Vec3& y) {
    Whole site;
    for (Index a = 0; a < 3; ++a) {
        site[a] = static_cast<Index>(std::lround(y[a]));
    }
    if (lattice == Lattice::fcc && site.sum() % 2 != 0) {
        const Vec3 rounded = y - site.cast<double>();
        Index most = 0;
        rounded.cwiseAbs().maxCoeff(&most);
        site[most] += rounded[most] < 0.0 ? -1 : 1;
    }
    return site;
}

/// Where the density has its origin, from its phases.
Vec3 origin_by_phases(const State& state, const CrystalInBox& crystal) {
    const Vec3 grid = crystal.cell(state.box()) / static_cast<double>(points_per_cell(crystal.lattice));
    const auto r = state.positions();
    using Sums = Eigen::Matrix<double, 3, 2>;
    const auto sums = sum_over<Sums>(state.execution(), state.count(), [&](Index i) {
        const Vec3 phase = 2.0 * std::numbers::pi * Vec3(r.col(i)).cwiseQuotient(grid);
        Sums of_atom;
        of_atom << phase.array().cos(), phase.array().sin();
        return of_atom;
    });
    Vec3 origin;
    for (Index a = 0; a < 3; ++a) {
        origin[a] = std::atan2(sums(a, 1), sums(a, 0)) / (2.0 * std::numbers::pi) * grid[a];
    }
    if (crystal.lattice == Lattice::fcc) {
        // The density at (1 1 1) is negative where even and odd grid points are exchanged.
        const double sign = sum_over(state.execution(), state.count(), [&](Index i) {
            const Vec3 phase = std::numbers::pi * (Vec3(r.col(i)) - origin).cwiseQuotient(grid);
            return phase.array().cos().prod();
        });
        origin[0] += sign < 0.0 ? grid[0] : 0.0;
    }
    return origin;
}

Index remainder(Index n, Index modulus) {
    return ((n % modulus) + modulus) % modulus;
}

}  // namespace

Vec3 CrystalInBox::cell(const Box& box) const {
    return box.edges().cwiseQuotient(Eigen::Matrix<Index, 3, 1>(cells, cells, layers).cast<double>());
}

double CrystalInBox::nearest_neighbours(const Box& box) const {
    const double edge = std::cbrt(cell(box).prod());
    return lattice == Lattice::fcc ? edge / std::numbers::sqrt2 : edge;
}

CrystalDisplacements crystal_displacements(const State& state, const CrystalInBox& crystal) {
    const Index points = points_per_cell(crystal.lattice);
    const Vec3 cell = crystal.cell(state.box());
    const Vec3 grid = cell / static_cast<double>(points);
    const auto r = state.positions();
    const Index atoms = state.count();
    Vec3 origin = origin_by_phases(state, crystal);
    Eigen::Matrix3Xd u(3, atoms);
    std::vector<Whole> sites(static_cast<std::size_t>(atoms));
    Vec3 mean = Vec3::Zero();
    for (int move = 0; move < most_moves; ++move) {
        for_each_index(state.execution(), atoms, [&](Index i) {
            const Vec3 from_origin = r.col(i) - origin;
            Whole& site = sites[static_cast<std::size_t>(i)];
            site = nearest_site(crystal.lattice, from_origin.cwiseQuotient(grid));
            u.col(i) = from_origin - site.cast<double>().cwiseProduct(grid);
        });
        mean = sum_over<Vec3>(state.execution(), atoms, [&](Index i) { return u.col(i); }) / static_cast<double>(atoms);
        if (mean.cwiseQuotient(cell).cwiseAbs().maxCoeff() < still) {
            break;
        }
        origin += mean;
    }
    u.colwise() -= mean;

    const Whole around = points * Whole(crystal.cells, crystal.cells, crystal.layers);
    std::vector<bool> taken(static_cast<std::size_t>(around.prod()), false);
    for (const Whole& site : sites) {
        const Index place = (remainder(site[0], around[0]) * around[1] + remainder(site[1], around[1])) * around[2] +
                            remainder(site[2], around[2]);
        taken[static_cast<std::size_t>(place)] = true;
    }
    return {std::move(u), crystal.sites() - static_cast<Index>(std::count(taken.begin(), taken.end(), true))};
}

}  // namespace ljmd
