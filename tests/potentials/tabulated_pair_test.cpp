#include "potentials/tabulated_pair.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "potentials/pair_table.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

TabulatedPair some_pair() {
    TabulatedPair pair{.name = "soft", .truncation = "shifted", .cutoff = {2.0, 0.0}, .first = 0.5};
    for (const double r : PairTable::distances(0.5, 2.0, 8)) {
        pair.energies.push_back(1.0 / r);
    }
    return pair;
}

}  // namespace

TEST_CASE("a tabulated pair is the potential of its table, truncated") {
    const TabulatedPair pair = some_pair();
    const PairPotential potential = pair.potential();
    const PairTable table(0.5, 2.0, pair.energies);
    const double shift = pair_term(table, 4.0).u;
    for (const double r : {0.6, 1.0, 1.7}) {
        CHECK(potential.untruncated(r).u == pair_term(table, r * r).u);
        CHECK(potential(r).u == pair_term(table, r * r).u - shift);
    }
    CHECK(potential(2.0).u == 0.0);
    CHECK(potential.formula() == "soft");
    CHECK(potential.is_custom());
}

TEST_CASE("a tabulated pair without a name, a truncation or a whole table is refused") {
    TabulatedPair wrong = some_pair();
    wrong.name = "";
    CHECK_THROWS_AS(wrong.potential(), InputError);
    wrong = some_pair();
    wrong.truncation = "cud";
    CHECK_THROWS_WITH(wrong.potential(), Contains("unknown truncation 'cud'"));
    wrong = some_pair();
    wrong.energies.pop_back();
    CHECK_THROWS_WITH(wrong.potential(), Contains("a table of 56 energies"));
}
