#include "observables/structure/crystal_order.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

std::map<std::string, ObservableAverage> by_name(const CrystalOrder& order) {
    std::map<std::string, ObservableAverage> found;
    for (const ObservableAverage& average : order.observables()) {
        found.emplace(average.name, average);
    }
    return found;
}

/// Atoms at Gaussian distances from their sites, each by itself: the crystal of Einstein.
State einstein_crystal(const CrystalInBox& crystal, const Box& box, double width, std::mt19937_64& generator) {
    std::normal_distribution<double> normal(0.0, width);
    std::vector<Vec3> positions = lattice_sites(crystal.lattice, crystal.cells, crystal.layers, box.edges(), box);
    for (Vec3& r : positions) {
        r += Vec3(normal(generator), normal(generator), normal(generator));
    }
    State state = test::state_of(positions, box);
    state.wrap();
    return state;
}

}  // namespace

TEST_CASE("reciprocal lattice vectors come in families, the shortest first, with one of each pair G and -G") {
    const auto [lattice, numbers, vectors] =
        GENERATE(std::tuple(Lattice::fcc, std::vector<int>{111, 200, 220, 311, 222, 400, 331, 420},
                            std::vector<int>{4, 3, 6, 12, 4, 3, 12, 12}),
                 std::tuple(Lattice::simple_cubic, std::vector<int>{100, 110, 111, 200, 210, 211, 220},
                            std::vector<int>{3, 6, 4, 3, 12, 12, 6}));
    const Box box(Vec3(4.8, 4.8, 4.8));
    CrystalOrder order({lattice, 3, 3}, std::ssize(numbers), Every(1));
    order.sample(test::crystal_state(lattice, 3, box), {});
    const DataTable table = order.tables().at(0);
    CHECK(table.name == "bragg");
    REQUIRE(table.rows.size() == numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const auto& row = table.rows[k];
        CHECK(100 * row[1] + 10 * row[2] + row[3] == numbers[k]);
        CHECK(row[4] == vectors[k]);
        CHECK(row[0] == Approx(2.0 * std::numbers::pi / 1.6 * std::hypot(row[1], row[2], row[3])).epsilon(1e-12));
        CHECK(row[5] == Approx(lattice_atoms(lattice, 3)).epsilon(1e-12));  // all atoms scatter alike
        CHECK(row[7] == Approx(1.0).epsilon(1e-12));
        CHECK(row[9] == Approx(1.0).epsilon(1e-12));
    }
}

TEST_CASE("of independent Gaussian displacements both mean squares and all Debye-Waller factors are those expected") {
    constexpr double width = 0.06;
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const CrystalInBox crystal{lattice, 3, 3};
    const Box box(Vec3(4.8, 4.8, 4.8));
    const auto n = static_cast<double>(crystal.sites());
    std::mt19937_64 generator(9);
    CrystalOrder order(crystal, 4, Every(1));
    for (int k = 0; k < 400; ++k) {
        order.sample(einstein_crystal(crystal, box, width, generator), {});
    }
    // Measured about the mean displacement, a mean square is smaller by one part in N.
    const double u2 = 3.0 * width * width * (1.0 - 1.0 / n);
    auto found = by_name(order);
    const auto check = [](const Estimate& estimate, double expected) {
        CAPTURE(estimate.mean, expected, estimate.standard_error);
        CHECK(std::abs(estimate.mean - expected) < 5.0 * estimate.standard_error);
        CHECK(estimate.standard_error > 0.0);
        CHECK(estimate.standard_error < 0.01 * std::abs(expected));
    };
    check(found.at("site_displacement").estimate.value(), u2);
    check(found.at("site_displacement_debye_waller").estimate.value(), u2);
    const double d = lattice == Lattice::fcc ? 1.6 / std::numbers::sqrt2 : 1.6;
    check(found.at("lindemann_ratio").estimate.value(), std::sqrt(u2) / d);
    CHECK(found.at("vacant_sites").estimate.value().mean == 0.0);
    const DataTable table = order.tables().at(0);
    for (const auto& row : table.rows) {
        const double factor = std::exp(-row[0] * row[0] * u2 / 3.0);
        CAPTURE(row[1], row[2], row[3]);
        CHECK(std::abs(row[7] - factor) < 5.0 * row[8]);
        CHECK(std::abs(row[9] - factor) < 5.0 * row[10]);
        CHECK(row[8] < 0.02 * factor);
        CHECK(row[10] < 0.02 * factor);
        // <|sum|^2>/N of independent displacements about their mean, to first order in 1/N of the rest
        CHECK(std::abs(row[5] - (n * factor + 1.0 - factor)) < 5.0 * row[6] + 0.5 * factor);
    }
}

TEST_CASE("of a fluid there is a Bragg peak, which is small, and nothing else, and a remark tells of vacancies") {
    const Box box(Vec3(4.8, 4.8, 4.8));
    const CrystalInBox crystal{Lattice::fcc, 3, 3};
    CrystalOrder fluid(crystal, 2, Every(1));
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
        fluid.sample(test::random_state(108, box, seed), {});
    }
    auto found = by_name(fluid);
    CHECK(found.at("bragg_peak").estimate.value().mean < 0.05);
    for (const char* name :
         {"site_displacement", "site_displacement_debye_waller", "lindemann_ratio", "vacant_sites"}) {
        CHECK_FALSE(found.at(name).estimate.has_value());
        CHECK_THAT(found.at(name).remark, Catch::Contains("is not there"));
    }
    CrystalOrder vacant(crystal, 2, Every(1));
    std::vector<Vec3> sites = lattice_sites(Lattice::fcc, 3, box);
    sites.pop_back();
    vacant.sample(test::state_of(sites, box), {});
    found = by_name(vacant);
    CHECK(found.at("vacant_sites").estimate.value().mean == Approx(1.0 / 108.0));
    CHECK_THAT(found.at("site_displacement").remark, Catch::Contains("0.93 % of the sites are vacant"));
}

TEST_CASE("cells are those of the box of each configuration") {
    CrystalOrder order({Lattice::fcc, 3, 3}, 3, Every(1));
    for (const double edge : {4.7, 4.8, 4.9}) {
        order.sample(test::crystal_state(Lattice::fcc, 3, Box(Vec3(edge, edge, edge))), {});
    }
    const auto found = by_name(order);
    CHECK(found.at("bragg_peak").estimate.value().mean == Approx(1.0).epsilon(1e-12));
    CHECK(found.at("site_displacement").estimate.value().mean < 1e-24);
}
