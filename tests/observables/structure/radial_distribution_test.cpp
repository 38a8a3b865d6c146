#include "observables/structure/radial_distribution.hpp"

#include <numbers>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"
#include "neighbors/verlet_list.hpp"

using namespace ljmd;

namespace {

constexpr std::size_t r_column = 0;
constexpr std::size_t g_column = 1;
constexpr std::size_t error_column = 2;
constexpr std::size_t coordination_column = 3;

double shell(Index bin, double width) {
    const auto k = static_cast<double>(bin);
    return 4.0 / 3.0 * std::numbers::pi * width * width * width * (std::pow(k + 1.0, 3) - std::pow(k, 3));
}

/// Ordered pairs in each bin by minimum image, bins found by comparing with their borders.
std::vector<double> counts_by_brute_force(const State& state, Index bins, double radius) {
    std::vector<double> counts(static_cast<std::size_t>(bins));
    const double width = radius / static_cast<double>(bins);
    for (Index i = 0; i < state.count(); ++i) {
        for (Index j = 0; j < state.count(); ++j) {
            const double r = state.box().minimum_image(state.positions().col(i) - state.positions().col(j)).norm();
            for (Index k = 0; k < bins && i != j; ++k) {
                if (r >= width * static_cast<double>(k) && r < width * static_cast<double>(k + 1)) {
                    counts[static_cast<std::size_t>(k)] += 1.0;
                }
            }
        }
    }
    return counts;
}

DataTable measured(const State& state, Index bins, double radius) {
    RadialDistribution rdf(bins, radius, Every(1));
    rdf.sample(state, {});
    return rdf.tables().at(0);
}

/// Atoms closer than the end of the bin that holds r.
double coordination(const DataTable& table, double r) {
    const double width = 2.0 * table.rows[0][r_column];
    return table.rows[static_cast<std::size_t>(r / width)][coordination_column];
}

}  // namespace

TEST_CASE("the histogram holds exactly the pairs of a brute-force count") {
    const Vec3 edges = GENERATE(Vec3(6.0, 6.0, 6.0), Vec3(5.0, 7.5, 11.0));
    const Index atoms = GENERATE(Index{2}, Index{30}, Index{300});
    const double share = GENERATE(1.0, 0.53);
    const Index bins = GENERATE(Index{1}, Index{37});
    const double radius = share * 0.5 * edges.minCoeff();
    const State state = test::random_state(atoms, Box(edges), 11);
    const DataTable table = measured(state, bins, radius);
    const std::vector<double> expected = counts_by_brute_force(state, bins, radius);
    REQUIRE(table.rows.size() == static_cast<std::size_t>(bins));
    const double width = radius / static_cast<double>(bins);
    const double ideal = static_cast<double>(atoms * (atoms - 1)) / state.box().volume();
    double sum = 0.0;
    for (Index k = 0; k < bins; ++k) {
        const auto row = static_cast<std::size_t>(k);
        CHECK(table.rows[row][g_column] * shell(k, width) * ideal == Approx(expected[row]).margin(1e-9).epsilon(1e-12));
        CHECK(table.rows[row][r_column] == Approx(width * (static_cast<double>(k) + 0.5)).epsilon(1e-14));
        sum += expected[row];
        CHECK(table.rows[row][coordination_column] == Approx(sum / static_cast<double>(atoms)).margin(1e-12));
    }
}

TEST_CASE("a bin holds its lower border and not its upper one, and nothing counts at the radius") {
    // Width 0.5, distances 1, 1.5 - g and 2 in a box of 4 = 2 radii.
    const Box box(Vec3::Constant(4.0));
    const auto bin_of = [&box](double r) {
        const DataTable table = measured(test::state_of({Vec3::Zero(), {r, 0.0, 0.0}}, box), 4, 2.0);
        for (std::size_t k = 0; k < 4; ++k) {
            if (table.rows[k][g_column] > 0.0) {
                return static_cast<int>(k);
            }
        }
        return -1;
    };
    CHECK(bin_of(0.25) == 0);
    CHECK(bin_of(1.0) == 2);
    CHECK(bin_of(1.5 - box.resolution()) == 2);
    CHECK(bin_of(1.5) == 3);
    CHECK(bin_of(2.0 - box.resolution()) == 3);
    CHECK(bin_of(2.0) == -1);
    CHECK(bin_of(3.0) == 2);  // the image at -1
}

TEST_CASE("g of two atoms is V over the shell: N (N - 1) pairs, not N^2") {
    const State state = test::state_of({Vec3::Zero(), {1.2, 0.0, 0.0}}, Box(Vec3(5.0, 6.0, 7.0)));
    const DataTable table = measured(state, 5, 2.5);
    CHECK(table.rows[2][g_column] == Approx(210.0 / shell(2, 0.5)));
    CHECK(table.rows[4][coordination_column] == Approx(1.0).epsilon(1e-13));
}

TEST_CASE("g of an ideal gas is 1 within three standard errors, for few atoms as for many") {
    const Index atoms = GENERATE(Index{5}, Index{100});
    const Box box(Vec3(6.0, 5.0, 5.5));
    RadialDistribution rdf(5, 2.5, Every(1));
    const int samples = atoms == 5 ? 4000 : 400;
    for (int k = 0; k < samples; ++k) {
        rdf.sample(test::random_state(atoms, box, static_cast<unsigned>(1000 + k)), {});
    }
    CHECK(rdf.samples() == samples);
    const DataTable table = rdf.tables().at(0);
    for (const auto& row : table.rows) {
        CAPTURE(row[r_column], row[g_column], row[error_column]);
        CHECK(row[error_column] > 0.0);
        CHECK(row[error_column] < 0.2);
        CHECK(std::abs(row[g_column] - 1.0) < 3.0 * row[error_column]);
    }
}

TEST_CASE("standard errors are those of counting for independent configurations") {
    // Pairs of an ideal gas are counted twice each: the number in a bin has the error (2 / n)^(1/2) of itself.
    const Index atoms = 100;
    const Box box(Vec3::Constant(5.0));
    const int samples = 512;
    RadialDistribution rdf(4, 2.5, Every(1));
    for (int k = 0; k < samples; ++k) {
        rdf.sample(test::random_state(atoms, box, static_cast<unsigned>(5000 + k)), {});
    }
    for (Index k = 0; k < 4; ++k) {
        const double pairs = samples * static_cast<double>(atoms * (atoms - 1)) / box.volume() * shell(k, 0.625);
        CHECK(rdf.tables().at(0).rows[static_cast<std::size_t>(k)][error_column] ==
              Approx(std::sqrt(2.0 / pairs)).epsilon(0.35));
    }
}

TEST_CASE("the shells of fcc hold 12, 6, 24 and 12 atoms") {
    const double constant = 1.6;  // shells at 1.13, 1.6, 1.96 and 2.26
    const State state = test::crystal_state(Lattice::fcc, 4, Box(Vec3::Constant(4.0 * constant)));
    const DataTable table = measured(state, 250, 2.5);
    CHECK(coordination(table, 1.0) == 0.0);
    CHECK(coordination(table, 1.3) == Approx(12.0).epsilon(1e-12));
    CHECK(coordination(table, 1.8) == Approx(18.0).epsilon(1e-12));
    CHECK(coordination(table, 2.1) == Approx(42.0).epsilon(1e-12));
    CHECK(coordination(table, 2.4) == Approx(54.0).epsilon(1e-12));
}

TEST_CASE("sampling leaves the state untouched to the last bit") {
    State state = test::shaken_crystal(4, 0.8442, 0.2, 12);  // unwrapped atoms
    VerletList list(0.3);
    list.prepare(state, 2.5);
    std::mt19937_64 generator(1);
    test::displace(state, 0.05, generator);
    state.mark_forces_current();
    const State before = state;
    RadialDistribution rdf(100, 2.5, Every(1));
    rdf.sample(state, {});
    const State& after = state;
    CHECK(after.positions_and_ghosts() == before.positions_and_ghosts());
    CHECK(after.velocities() == before.velocities());
    CHECK(after.ids() == before.ids());
    CHECK(after.order_version() == before.order_version());
    CHECK(after.ghost_count() == before.ghost_count());
    CHECK(after.image(5) == before.image(5));
    CHECK(after.forces_are_current());
}

TEST_CASE("g does not depend on wrapping and order") {
    State state = test::shaken_crystal(3, 0.8442, 0.2, 13);
    const DataTable before = measured(state, 50, 2.5);
    state.wrap();
    std::vector<Index> order(108);
    for (std::size_t k = 0; k < 108; ++k) {
        order[k] = static_cast<Index>((7 * k) % 108);
    }
    state.reorder(order);
    const DataTable after = measured(state, 50, 2.5);
    for (std::size_t k = 0; k < before.rows.size(); ++k) {
        CHECK(after.rows[k][g_column] == before.rows[k][g_column]);
    }
}

TEST_CASE("the table names its columns, and one atom has nobody around it") {
    const DataTable table = measured(test::random_state(1, Box(Vec3::Constant(5.0)), 1), 3, 2.5);
    CHECK(table.name == "rdf");
    CHECK(table.columns == std::vector<std::string>{"r", "g", "g_standard_error", "coordination_number",
                                                    "coordination_number_standard_error"});
    for (const auto& row : table.rows) {
        REQUIRE(row.size() == 5);
        CHECK(std::isnan(row[g_column]));  // there are no pairs
        CHECK(row[coordination_column] == 0.0);
        CHECK(std::isnan(row[error_column]));
    }
}

TEST_CASE("the distribution is due at its schedule") {
    const RadialDistribution rdf(3, 2.5, Every(50));
    CHECK(rdf.due(0));
    CHECK_FALSE(rdf.due(49));
    CHECK(rdf.due(150));
    CHECK(rdf.samples() == 0);
}

TEST_CASE("the structure factor from g is its sine transform") {
    const State state = test::shaken_crystal(4, 0.8442, 0.1, 3);
    RadialDistribution rdf(60, 3.0, Every(1));
    rdf.sample(state, {});
    const auto tables = rdf.tables();
    REQUIRE(tables.size() == 2);
    CHECK(tables[1].name == "sk_from_rdf");
    REQUIRE(tables[1].rows.size() == 53);
    const double others = static_cast<double>(state.count() - 1) / state.box().volume();
    CHECK(tables[1].rows[0][0] == Approx(2.0 * std::numbers::pi / 3.0).epsilon(1e-13));
    for (std::size_t m = 0; m < 53; ++m) {
        const double k = std::numbers::pi * static_cast<double>(m + 8) / 12.0;
        double integral = 0.0;
        for (const auto& row : tables[0].rows) {
            integral += 0.05 * row[r_column] * (row[g_column] - 1.0) * std::sin(k * row[r_column]) / k;
        }
        CHECK(tables[1].rows[m][0] == Approx(k).epsilon(1e-13));
        CHECK(tables[1].rows[m][1] == Approx(1.0 + 4.0 * std::numbers::pi * others * integral).epsilon(1e-10));
    }
}

TEST_CASE("a curve of the structure factor has no wave longer than g(r) reaches, and none with fewer than 8 bins") {
    const auto tables_of = [](Index bins) {
        RadialDistribution rdf(bins, 2.0, Every(1));
        rdf.sample(test::shaken_crystal(4, 0.8442, 0.1, 3), {});
        return rdf.tables();
    };
    CHECK(tables_of(7).size() == 1);
    REQUIRE(tables_of(8).size() == 2);
    REQUIRE(tables_of(8)[1].rows.size() == 1);
    CHECK(tables_of(8)[1].rows[0][0] == Approx(std::numbers::pi).epsilon(1e-13));
}

TEST_CASE("in a box that changes each configuration counts by its own density, and g ends at half the shortest edge") {
    const State large = test::random_state(200, Box(Vec3(8.0, 9.0, 10.0)), 5);
    const State small = test::random_state(200, Box(Vec3(8.0, 6.5, 10.0)), 6);
    constexpr Index bins = 20;
    constexpr double radius = 4.0;
    RadialDistribution rdf(bins, radius, Every(1));
    rdf.sample(large, {});
    CHECK(rdf.tables().size() == 2);
    rdf.sample(small, {});
    const auto tables = rdf.tables();
    REQUIRE(tables.size() == 1);  // S(k) is an integral to the radius
    REQUIRE(tables[0].rows.size() == 20);
    for (Index k = 0; k < bins; ++k) {
        const auto& row = tables[0].rows[static_cast<std::size_t>(k)];
        if (k >= 16) {  // 3.2 < 6.5/2 < 3.4
            CHECK(std::isnan(row[g_column]));
            CHECK(std::isnan(row[coordination_column]));
            continue;
        }
        double expected = 0.0;
        for (const State* state : {&large, &small}) {
            const double counted = counts_by_brute_force(*state, bins, radius)[static_cast<std::size_t>(k)];
            expected += 0.5 * counted * state->box().volume() / (200.0 * 199.0 * shell(k, 0.2));
        }
        CHECK(row[g_column] == Approx(expected).epsilon(1e-13));
    }
    REQUIRE(rdf.observables().size() == 1);
    CHECK_FALSE(rdf.observables()[0].estimate);
}

TEST_CASE("the coordination number of a crystal is that of its first shell") {
    // Shells at 1, sqrt 2, sqrt 3, 2 of the nearest distance: the emptiest bin behind the peak lies before sqrt 2.
    const State crystal = test::crystal_state(Lattice::fcc, 3, cubic_box(108, 1.0));
    RadialDistribution rdf(200, 0.5 * crystal.box().shortest_edge(), Every(1));
    CHECK(rdf.observables().empty());
    for (int n = 0; n < 4; ++n) {
        rdf.sample(crystal, {});
    }
    const auto found = rdf.observables();
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "coordination_number");
    CHECK(found[0].estimate->mean == Approx(12.0).epsilon(1e-13));
}

TEST_CASE("there is no coordination number where g has no peak, or its minimum may lie further out, or for a gas") {
    const auto check_none = [](const State& state, double radius) {
        RadialDistribution rdf(20, radius, Every(1));
        for (int n = 0; n < 4; ++n) {
            rdf.sample(state, {});
        }
        const auto found = rdf.observables();
        REQUIRE(found.size() == 1);
        CHECK_FALSE(found[0].estimate.has_value());
        CHECK_FALSE(found[0].remark.empty());
    };
    check_none(test::random_state(1, Box(Vec3::Constant(5.0)), 1), 2.5);
    check_none(test::crystal_state(Lattice::fcc, 3, cubic_box(108, 1.0)), 1.5);
    RadialDistribution gas(100, 3.0, Every(1));
    for (unsigned n = 0; n < 200; ++n) {
        gas.sample(test::random_state(50, Box(Vec3::Constant(6.0)), n), {});
    }
    CHECK_FALSE(gas.observables().at(0).estimate.has_value());
}
