#include "observables/pairs_too_near.hpp"

#include <vector>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"
#include "potentials/pair_table.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

/// u = 1/r from some distance on.
PairPotential table_from(double first) {
    std::vector<double> energies;
    for (const double r : PairTable::distances(first, 2.5, 8)) {
        energies.push_back(1.0 / (0.1 + r));
    }
    return PairPotential::custom("own", PairTable(first, 2.5, energies), "shifted", {.radius = 2.5});
}

/// Three atoms in a row, at distances of 0.6 and 0.9, the second across a wall.
State row() {
    return test::state_of({{7.3, 1.0, 1.0}, {7.9, 1.0, 1.0}, {0.8, 1.0, 1.0}}, Box(Vec3(8.0, 8.0, 8.0)));
}

}  // namespace

TEST_CASE("pairs are too near below the first distance of a table, and never for a formula") {
    CHECK(table_from(0.7).starts_at() == 0.7);
    CHECK(pairs_too_near(row(), table_from(0.7)).count == 1);
    CHECK(pairs_too_near(row(), table_from(0.95)).count == 2);
    CHECK(pairs_too_near(row(), table_from(0.5)).count == 0);
    CHECK(pairs_too_near(row(), table_from(0.0)).count == 0);
    const PairPotential formula = PairPotential::lennard_jones("shifted", {.radius = 2.5});
    CHECK(formula.starts_at() == 0.0);
    CHECK(pairs_too_near(row(), formula).count == 0);
    CHECK(too_near_in_words(NearPairs{}, formula).empty());
    CHECK_THAT(too_near_in_words(pairs_too_near(row(), table_from(0.7)), table_from(0.7)),
               Contains("1 pair of atoms is nearer than 0.7,") && Contains("'own'") && Contains("0.6 apart"));
    CHECK_THAT(too_near_in_words(pairs_too_near(row(), table_from(0.95)), table_from(0.95)),
               Contains("2 pairs of atoms are"));
}

TEST_CASE("samples with such pairs are counted, also in two parts") {
    const State apart = test::state_of({{1.0, 1.0, 1.0}, {3.0, 1.0, 1.0}, {5.0, 1.0, 1.0}}, Box(Vec3(8.0, 8.0, 8.0)));
    PairsTooNear first(table_from(0.95));
    first.sample(apart);
    CHECK(first.remark().empty());
    first.sample(row());
    Archive written;
    first.archive(written);
    PairsTooNear second(table_from(0.95));
    Archive read(written.bytes());
    second.archive(read);
    second.sample(apart);
    second.sample(row());
    CHECK_THAT(second.remark(), Contains("in 2 of 4 samples") && Contains("1 pairs a sample") && Contains("0.6 apart"));
}
