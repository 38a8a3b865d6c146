#include "observables/structure/crystal_displacements.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

/// A crystal somewhere in its box, in any order, with known displacements.
struct Shaken {
    CrystalInBox crystal;
    State state;
    Eigen::Matrix3Xd u;
};

Shaken shaken(const CrystalInBox& crystal, const Box& box, const Vec3& shift, double width) {
    std::vector<Vec3> sites = lattice_sites(crystal.lattice, crystal.cells, crystal.layers, box.edges(), box);
    std::mt19937_64 generator(5);
    std::shuffle(sites.begin(), sites.end(), generator);
    std::normal_distribution<double> normal(0.0, width);
    Eigen::Matrix3Xd u(3, std::ssize(sites));
    for (Index i = 0; i < u.cols(); ++i) {
        u.col(i) = Vec3(normal(generator), normal(generator), normal(generator));
        sites[static_cast<std::size_t>(i)] += u.col(i) + shift;
    }
    State state = test::state_of(sites, box);
    state.wrap();
    u.colwise() -= Vec3(u.rowwise().mean());
    return {crystal, std::move(state), u};
}

}  // namespace

TEST_CASE("displacements are those from the nearest sites of a crystal that lies anywhere in its box") {
    const Vec3 shift =
        GENERATE(Vec3(0.0, 0.0, 0.0), Vec3(0.3, -0.7, 11.1), Vec3(0.79, 0.0, 0.0), Vec3(-0.4, 1.2, 0.81));
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const CrystalInBox crystal{lattice, 3, 4};
    const double width = GENERATE(0.0, 0.03, 0.07);
    const Shaken made = shaken(crystal, Box(Vec3(4.8, 4.7, 6.4)), shift, width);
    const CrystalDisplacements found = crystal_displacements(made.state, crystal);
    CAPTURE(shift.transpose(), width, lattice == Lattice::fcc);
    CHECK((found.u - made.u).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(found.vacant == 0);
    CHECK(Vec3(found.u.rowwise().sum()).norm() < 1e-12);
}

TEST_CASE("a site without an atom is vacant, whether its atom is gone or at another site") {
    const Box box(Vec3(6.4, 6.4, 6.4));
    const CrystalInBox crystal{Lattice::fcc, 4, 4};
    std::vector<Vec3> sites = lattice_sites(Lattice::fcc, 4, box);
    sites[7] = sites[100] + Vec3(0.3, 0.0, 0.0);
    CHECK(crystal_displacements(test::state_of(sites, box), crystal).vacant == 1);
    sites.erase(sites.begin() + 7);
    const CrystalDisplacements found = crystal_displacements(test::state_of(sites, box), crystal);
    CHECK(found.vacant == 1);
    CHECK(found.u.cwiseAbs().maxCoeff() < 1e-12);
}

TEST_CASE("nearest neighbours of cubic cells are as far apart as the sites are") {
    const Box box(Vec3(6.0, 6.0, 6.0));
    for (const Lattice lattice : {Lattice::fcc, Lattice::simple_cubic}) {
        const CrystalInBox crystal{lattice, 3, 3};
        const std::vector<Vec3> sites = lattice_sites(lattice, 3, box);
        double nearest = 100.0;
        for (std::size_t i = 1; i < sites.size(); ++i) {
            nearest = std::min(nearest, box.minimum_image(sites[i] - sites[0]).norm());
        }
        CHECK(crystal.nearest_neighbours(box) == Approx(nearest).epsilon(1e-12));
        CHECK(crystal.sites() == std::ssize(sites));
    }
}
