#include "potentials/pair_table.hpp"

#include <cmath>
#include <limits>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/potentials/formulas/lennard_jones.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

double lennard_jones(double r) {
    return pair_term(LennardJones(), r * r).u;
}

template <class Function>
PairTable table_of(const Function& u, double first, double last, Index pieces) {
    std::vector<double> energies;
    for (const double r : PairTable::distances(first, last, pieces)) {
        energies.push_back(u(r));
    }
    return {first, last, energies};
}

struct Errors {
    double u = 0.0;
    double w = 0.0;
};

/// The largest errors of energy and force in units of 1 + |value|, between 0.8 and 2.5.
Errors errors_of(const PairTable& table) {
    Errors most;
    for (double r = 0.8; r < 2.5; r += 1.3e-4) {
        const PairTerm<double> found = pair_term(table, r * r);
        const PairTerm<double> exact = pair_term(LennardJones(), r * r);
        most.u = std::max(most.u, std::abs(found.u - exact.u) / (1.0 + std::abs(exact.u)));
        most.w = std::max(most.w, std::abs(found.w - exact.w) / (1.0 + std::abs(exact.w)));
    }
    return most;
}

}  // namespace

TEST_CASE("a pair table has energy and force of its formula, with an error that falls like the 8th power") {
    const Errors coarse = errors_of(table_of(lennard_jones, 0.5, 2.5, 16));
    const Errors medium = errors_of(table_of(lennard_jones, 0.5, 2.5, 32));
    const Errors fine = errors_of(table_of(lennard_jones, 0.5, 2.5, 256));
    CHECK(coarse.u > 100.0 * medium.u);
    CHECK(coarse.w > 60.0 * medium.w);
    CHECK(fine.u < 1e-13);
    CHECK(fine.w < 1e-11);
}

TEST_CASE("the force of a pair table is the derivative of its energy, also below its first distance") {
    const PairTable table = table_of(lennard_jones, 0.9, 2.5, 8);
    for (const double r : {0.2, 0.7, 0.95, 1.34, 2.2}) {
        const double h = 1e-6;
        const double slope =
            (pair_term(table, (r + h) * (r + h)).u - pair_term(table, (r - h) * (r - h)).u) / (2.0 * h);
        CHECK(pair_term(table, r * r).w == Approx(-slope / r).epsilon(1e-7));
    }
}

TEST_CASE("pieces of a pair table meet: there is no jump of energy, at its ends its energies are the formula's") {
    const PairTable table = table_of(lennard_jones, 1.0, 2.0, 4);
    for (const double r : {1.0, 1.25, 1.5, 1.75, 2.0}) {
        CHECK(pair_term(table, r * r).u == Approx(lennard_jones(r)).epsilon(1e-12).margin(1e-12));
        CHECK(pair_term(table, r * r * (1.0 - 1e-14)).u == Approx(lennard_jones(r)).epsilon(1e-12).margin(1e-12));
    }
}

TEST_CASE("a pair table may begin at zero") {
    const PairTable core = table_of([](double r) { return std::exp(-r * r); }, 0.0, 3.0, 32);
    CHECK(pair_term(core, 1e-8).u == Approx(1.0));
    CHECK(pair_term(core, 0.25).w == Approx(2.0 * std::exp(-0.25)));
}

TEST_CASE("a pair table refuses what is none") {
    const double nan = std::nan("");
    CHECK_THROWS_AS(PairTable::distances(1.0, 1.0, 4), InputError);
    CHECK_THROWS_AS(PairTable::distances(-0.1, 1.0, 4), InputError);
    CHECK_THROWS_AS(PairTable::distances(nan, 1.0, 4), InputError);
    CHECK_THROWS_AS(PairTable::distances(0.5, std::numeric_limits<double>::infinity(), 4), InputError);
    CHECK_THROWS_AS(PairTable::distances(0.5, 1.0, 0), InputError);
    CHECK_THROWS_AS(PairTable::distances(0.5, 1.0, PairTable::max_pieces + 1), InputError);
    CHECK_THROWS_WITH(PairTable(0.5, 1.0, std::vector<double>(7)), Contains("7 energies"));
    CHECK_THROWS_WITH(PairTable(0.5, 1.0, {}), Contains("0 energies"));
    CHECK_THROWS_WITH(table_of([](double r) { return 1.0 / (r - 0.5); }, 0.5, 1.0, 2), Contains("at r = 0.5"));
}
