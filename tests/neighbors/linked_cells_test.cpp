#include "neighbors/linked_cells.hpp"

#include <limits>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

TEST_CASE("linked cells find the pairs of all-pairs in random boxes") {
    const Vec3 shape = GENERATE(Vec3(1.0, 1.0, 1.0), Vec3(1.0, 1.3, 3.0), Vec3(4.0, 1.0, 1.0));
    const double cutoff = GENERATE(1.1, 2.5, 3.2);
    const double density = GENERATE(0.05, 0.4, 0.8442, 1.2);
    const Box box(2.05 * cutoff * shape);
    const auto atoms = static_cast<Index>(std::min(density * box.volume(), 1000.0));
    State state = test::random_state(atoms, box, 41);
    CAPTURE(shape.transpose(), cutoff, density, atoms);
    const auto expected = test::all_pairs_within(state, cutoff);
    LinkedCells search;
    search.prepare(state, cutoff);
    CHECK(test::pairs_within(search, state, cutoff) == expected);
}

TEST_CASE("linked cells stay right while atoms move without bounds") {
    const double cutoff = 2.5;
    State state = test::random_state(200, Box(Vec3(5.0, 5.5, 8.0)), 6);  // the first edge is 2 rc exactly
    std::mt19937_64 generator(12);
    LinkedCells search;
    for (int step = 0; step < 20; ++step) {
        test::displace(state, 0.4, generator);
        const auto expected = test::all_pairs_within(state, cutoff);
        search.prepare(state, cutoff);
        CHECK(test::pairs_within(search, state, cutoff) == expected);
    }
    CHECK(search.statistics().preparations == 20);
    CHECK(search.statistics().rebuilds == 20);
}

TEST_CASE("linked cells agree with all-pairs on shells of a crystal that lie at the cutoff") {
    const Lattice lattice = GENERATE(Lattice::fcc, Lattice::simple_cubic);
    const double constant = GENERATE(1.5, 1.0 / 3.0 + 1.25, 1.679, 2.0);
    const double shell = GENERATE(0.5, 1.0, 1.5, 2.0);  // r^2 in units of the lattice constant's
    const double cutoff = constant * std::sqrt(shell);
    State state = test::crystal_state(lattice, 4, Box(Vec3::Constant(4.0 * constant)));
    const auto expected = test::all_pairs_within(state, cutoff);
    LinkedCells search;
    search.prepare(state, cutoff);
    CAPTURE(constant, shell);
    CHECK(test::pairs_within(search, state, cutoff) == expected);
}

TEST_CASE("linked cells see each pair from both sides with opposite separations") {
    State state = test::random_state(120, Box(Vec3::Constant(5.0)), 8);
    LinkedCells search;
    search.prepare(state, 2.5);
    CHECK(test::separations_are_opposite(search, state, 2.5));
}

TEST_CASE("linked cells handle no atom, one and two") {
    const Box box(Vec3::Constant(5.0));
    LinkedCells search;
    State nobody(0, box);
    search.prepare(nobody, 2.5);

    State one = test::random_state(1, box, 1);
    search.prepare(one, 2.5);
    CHECK(test::pairs_within(search, one, 2.5).empty());

    State two = test::state_of({{0.1, 4.9, 2.0}, {4.9, 0.1, 2.0}}, box);
    search.prepare(two, 2.5);
    CHECK(test::pairs_within(search, two, 2.5) == std::vector<test::OrderedPair>{{0, 1}, {1, 0}});
}

TEST_CASE("linked cells report a position that is not finite") {
    State state = test::random_state(3, Box(Vec3::Constant(5.0)), 1);
    state.write_positions()(1, 2) = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(LinkedCells().prepare(state, 2.5), PhysicsError);
}
