#include "ljmd/model/lattice.hpp"

#include <cmath>
#include <map>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

/// For each atom, how many others lie at each distance below `range`; distances in units of 1e-9.
std::vector<std::map<long, int>> shells(const std::vector<Vec3>& sites, const Box& box, double range) {
    std::vector<std::map<long, int>> counts(sites.size());
    for (std::size_t i = 0; i < sites.size(); ++i) {
        for (std::size_t j = 0; j < sites.size(); ++j) {
            const double r = box.minimum_image(sites[i] - sites[j]).norm();
            if (i != j && r < range) {
                ++counts[i][std::lround(r * 1e9)];
            }
        }
    }
    return counts;
}

}  // namespace

TEST_CASE("atoms of a crystal are counted") {
    CHECK(sites_per_cell(Lattice::fcc) == 4);
    CHECK(sites_per_cell(Lattice::simple_cubic) == 1);
    CHECK(lattice_atoms(Lattice::fcc, 6) == 864);
    CHECK(lattice_atoms(Lattice::simple_cubic, 10) == 1000);
    CHECK(lattice_atoms(Lattice::fcc, 0) == 0);
    CHECK(lattice_atoms(Lattice::fcc, 1000) == 4000000000);
    CHECK(lattice_atoms(Lattice::fcc, Index{1} << 20) == Index{1} << 62);
    CHECK_THROWS_AS(lattice_atoms(Lattice::fcc, (Index{1} << 20) + 1), InputError);
    CHECK_THROWS_AS(lattice_atoms(Lattice::simple_cubic, -1), InputError);
}

TEST_CASE("the nearest crystals enclose a number of atoms, and meet only where it fits") {
    for (const Lattice lattice : {Lattice::fcc, Lattice::simple_cubic}) {
        const Index largest = lattice == Lattice::fcc ? 41285 : 65536;  // up to about 2^48 atoms
        for (Index cells = 2; cells <= largest; cells += 1 + cells / 50) {
            const Index atoms = lattice_atoms(lattice, cells);
            const auto exact = nearest_cells(lattice, atoms);
            const auto fewer = nearest_cells(lattice, atoms - 1);
            const auto more = nearest_cells(lattice, atoms + 1);
            CAPTURE(cells);
            REQUIRE(exact.below == cells);
            REQUIRE(exact.above == cells);
            REQUIRE(fewer.below == cells - 1);
            REQUIRE(fewer.above == cells);
            REQUIRE(more.below == cells);
            REQUIRE(more.above == cells + 1);
        }
    }
    CHECK(nearest_cells(Lattice::fcc, 4).below == 1);
    CHECK(nearest_cells(Lattice::fcc, 4).above == 1);
    for (const Index atoms : {0, 1, 2, 3}) {  // one cell holds more, but does not fit
        CHECK(nearest_cells(Lattice::fcc, atoms).below == 1);
        CHECK(nearest_cells(Lattice::fcc, atoms).above == 2);
    }
}

TEST_CASE("a cubic box has the density that was asked for") {
    for (const Index atoms : {1, 2, 864, 1000000}) {
        for (const double density : {1e-6, 0.35, 0.8442, 1.2}) {
            const Box box = cubic_box(atoms, density);
            CHECK(box.edges() == Vec3::Constant(box.edges()[0]));
            CHECK(static_cast<double>(atoms) / box.volume() == Approx(density).epsilon(1e-14));
        }
    }
}

TEST_CASE("crystals: number, place and shells of neighbours") {
    struct Shell {
        double distance;  // in edges of the cubic cell
        int neighbours;
    };
    struct Crystal {
        Lattice lattice;
        std::vector<Shell> shells;
    };
    const Crystal crystals[] = {
        {Lattice::fcc, {{std::sqrt(0.5), 12}, {1.0, 6}, {std::sqrt(1.5), 24}}},
        {Lattice::simple_cubic, {{1.0, 6}, {std::sqrt(2.0), 12}}},
    };
    for (const Crystal& crystal : crystals) {
        for (const Index cells : {3, 4, 5}) {
            const Index atoms = lattice_atoms(crystal.lattice, cells);
            const Box box = cubic_box(atoms, 0.8442);
            const double cell = box.edges()[0] / static_cast<double>(cells);
            const auto sites = lattice_sites(crystal.lattice, cells, box);
            REQUIRE(static_cast<Index>(sites.size()) == atoms);
            CHECK(sites[0] == Vec3::Zero());
            for (const Vec3& site : sites) {
                REQUIRE(site == box.snap(site));
                REQUIRE(box.crossings(site) == Vec3::Zero());
            }
            for (const auto& found : shells(sites, box, 1.01 * crystal.shells.back().distance * cell)) {
                std::map<long, int> expected;
                for (const Shell& shell : crystal.shells) {
                    expected[std::lround(shell.distance * cell * 1e9)] = shell.neighbours;
                }
                REQUIRE(found == expected);
            }
        }
    }
}

TEST_CASE("one cell makes a crystal, and a box of unequal edges is filled") {
    CHECK(lattice_sites(Lattice::simple_cubic, 1, cubic_box(1, 1.0)) == std::vector<Vec3>{Vec3::Zero()});
    const Box box(Vec3(2.0, 4.0, 8.0));
    const std::vector<Vec3> expected = {{0.0, 0.0, 0.0}, {1.0, 2.0, 0.0}, {1.0, 0.0, 4.0}, {0.0, 2.0, 4.0}};
    CHECK(lattice_sites(Lattice::fcc, 1, box) == expected);
}

TEST_CASE("a crystal may have another number of cells along z, and leave room above") {
    const Vec3 edges = crystal_edges(Lattice::fcc, 3, 5, 0.8);
    CHECK(edges[0] == cubic_box(108, 0.8).edges()[0]);
    CHECK(edges[1] == edges[0]);
    CHECK(edges[2] == Approx(edges[0] * 5.0 / 3.0).epsilon(1e-15));
    CHECK(lattice_atoms(Lattice::fcc, 3, 5) == 180);
    CHECK(180.0 / edges.prod() == Approx(0.8).epsilon(1e-14));
    const Box box(Vec3(edges[0], edges[1], 30.0));
    const auto sites = lattice_sites(Lattice::fcc, 3, 5, edges, box);
    REQUIRE(sites.size() == 180);
    const double plane = edges[2] / 10.0;
    std::map<long, int> in_plane;
    for (const Vec3& site : sites) {
        REQUIRE(site == box.snap(site));
        ++in_plane[std::lround(site[2] / plane * 1e6)];
    }
    CHECK(in_plane.size() == 10);
    CHECK(in_plane.rbegin()->first == 9000000);
    CHECK(in_plane.rbegin()->second == 18);
    CHECK_THROWS_AS(lattice_atoms(Lattice::fcc, 3, -1), InputError);
    CHECK_THROWS_AS(lattice_atoms(Lattice::fcc, 3, (Index{1} << 20) + 1), InputError);
}

TEST_CASE("random positions lie in the box, on its grid, and fill it evenly") {
    const Box box(Vec3(3.1, 47.0, 0.59));
    constexpr Index atoms = 64000;
    const auto positions = random_positions(atoms, box, 1967);
    REQUIRE(static_cast<Index>(positions.size()) == atoms);
    constexpr int bins = 8;  // along each edge
    std::map<int, double> counts;
    for (const Vec3& r : positions) {
        REQUIRE(r == box.snap(r));
        REQUIRE(box.crossings(r) == Vec3::Zero());
        const Vec3 bin = (bins * r.cwiseQuotient(box.edges())).array().floor();
        counts[static_cast<int>((bin[2] * bins + bin[1]) * bins + bin[0])] += 1.0;
    }
    const double expected = static_cast<double>(atoms) / (bins * bins * bins);
    double chi_square = 0.0;
    for (int bin = 0; bin < bins * bins * bins; ++bin) {
        chi_square += (counts[bin] - expected) * (counts[bin] - expected) / expected;
    }
    CHECK(chi_square > 432.0);  // 511 degrees of freedom: 99 % lie between 432 and 597
    CHECK(chi_square < 597.0);
}

TEST_CASE("a random position that rounds to the far wall is at the near one") {
    const Box box(Vec3(1e15, 1.0, 1.0));  // so long that its grid has two points along the short edges
    REQUIRE(box.resolution() == 0.5);
    for (const Vec3& r : random_positions(100, box, 1)) {
        REQUIRE(box.crossings(r) == Vec3::Zero());
    }
}

TEST_CASE("random positions depend on seed and id only") {
    const Box box(Vec3(3.0, 4.0, 5.0));
    const auto few = random_positions(10, box, 3);
    const auto more = random_positions(1000, box, 3);
    const auto others = random_positions(10, box, 4);
    CHECK(random_positions(0, box, 3).empty());
    for (std::size_t i = 0; i < few.size(); ++i) {
        CHECK(few[i] == more[i]);
        CHECK(few[i] != others[i]);
    }
}

TEST_CASE("lattices are found by their names, and no others") {
    CHECK(lattice_names() == std::vector<std::string>{"fcc", "simple-cubic"});
    CHECK(find_lattice("fcc") == Lattice::fcc);
    CHECK(find_lattice("simple-cubic") == Lattice::simple_cubic);
    CHECK_THROWS_WITH(find_lattice("bcc"), Catch::Contains("unknown lattice 'bcc', allowed: fcc, simple-cubic"));
}
