#include "neighbors/pairs_within.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

using Separations = std::vector<std::array<double, 3>>;

Separations found_by(const PairsWithin& pairs) {
    Separations found;
    for (Index part = 0; part < pairs.part_count(); ++part) {
        pairs.for_each(part, [&](const Neighbor& near) { found.push_back({near.dx, near.dy, near.dz}); });
    }
    return found;
}

}  // namespace

TEST_CASE("the pairs within a cutoff are those of all pairs, from both sides, and the state stays as it is") {
    const double cutoff = GENERATE(0.7, 1.5, 2.0);
    State state = test::random_state(400, Box(Vec3(4.0, 5.0, 6.0)), 3);
    const State before = state;
    Separations found = found_by(PairsWithin(state, cutoff));
    std::sort(found.begin(), found.end());
    CHECK(state.positions() == before.positions());
    CHECK(state.ids() == before.ids());
    AllPairs reference;
    reference.prepare(state, cutoff);
    CHECK(found == test::separations_within(reference, state, cutoff));
    CHECK(found.size() > 400);
}

TEST_CASE("neighbours are within the cutoff, and atoms are those of the state by their ids") {
    const State state = test::random_state(300, Box(Vec3(4.0, 5.0, 6.0)), 4);
    const PairsWithin pairs(state, 1.5);
    for (Index i = 0; i < state.count(); ++i) {
        const Index id = pairs.atoms().ids()[static_cast<std::size_t>(i)];
        REQUIRE(pairs.atoms().positions().col(i) == state.positions().col(id));
    }
    for (Index part = 0; part < pairs.part_count(); ++part) {
        const AtomRange range = pairs.atoms_of(part);
        pairs.for_each(part, [&](const Neighbor& near) {
            REQUIRE(near.r2 < 2.25);
            REQUIRE(near.r2 == near.dx * near.dx + near.dy * near.dy + near.dz * near.dz);
            REQUIRE((range.first <= near.i && near.i < range.last));
        });
    }
}

TEST_CASE("neither the order of atoms in memory nor the edges that they have crossed changes the order of pairs") {
    State state = test::random_state(300, Box(Vec3(4.0, 5.0, 6.0)), 5);
    const Separations found = found_by(PairsWithin(state, 1.5));
    std::vector<Index> order;
    for (Index i = 0; i < state.count(); ++i) {
        order.push_back((37 * i + 11) % state.count());
    }
    state.reorder(order);
    auto r = state.write_positions();
    r(0, 7) += 4.0;
    CHECK(found_by(PairsWithin(state, 1.5)) == found);
}

TEST_CASE("a cutoff beyond half the box is a mistake of the caller") {
    const State state = test::random_state(10, Box(Vec3(4.0, 5.0, 6.0)), 6);
    CHECK_NOTHROW(PairsWithin(state, 2.0));
    CHECK_THROWS_AS(PairsWithin(state, 2.01), ContractViolation);
    CHECK_THROWS_AS(PairsWithin(state, 0.0), ContractViolation);
}
