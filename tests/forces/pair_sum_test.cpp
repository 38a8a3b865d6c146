#include "forces/pair_sum.hpp"

#include <cmath>
#include "catch.hpp"

#include "ljmd/detail/potentials/pair_term.hpp"

using namespace ljmd;

namespace {

/// u = r^2, w = 3 for every pair: sums that can be done by hand.
struct Counting {
    PairTerm<double> operator()(const PairDistance<double>& d) const {
        ++calls;
        return {d.r2, 3.0};
    }
    mutable Index calls = 0;
};

/// Atoms in a row, x = 0, 1, 2, ...: every other one is a candidate, whatever the cutoff. Pairs of atoms of the same
/// half of the row come once for both, the others from both sides; if wanted, all pairs come once.
struct Row {
    bool all_once = false;

    Index part_count(const State& /*state*/) const { return 2; }
    AtomRange atoms_of(const State& state, Index part) const {
        const Index half = state.count() / 2;
        return part == 0 ? AtomRange{0, half} : AtomRange{half, state.count()};
    }
    template <class Visit>
    void for_each_candidate(const State& state, Index part, Visit&& visit) const {
        const AtomRange atoms = atoms_of(state, part);
        for (Index i = atoms.first; i < atoms.last; ++i) {
            for (Index j = 0; j < state.count(); ++j) {
                const bool once = all_once || (j >= atoms.first && j < atoms.last);
                if (once ? j > i : j != i) {
                    visit(PairVisit{i, j, static_cast<double>(i - j), 0.5 * static_cast<double>(i < j ? 1 : -1), 0.0,
                                    once});
                }
            }
        }
    }
};

}  // namespace

TEST_CASE("the sum takes each pair inside the cutoff once, and candidates beyond it not at all") {
    State state(4);
    const Counting pair;
    // r^2 = 1.25 for neighbours, 4.25 for next neighbours, which lie beyond.
    const Evaluation sum = sum_pairs<Request::forces_and_energy>(pair, Row(), 2.0, state);
    CHECK(pair.calls == 4);  // the pair in the middle is of two parts
    CHECK(sum.potential_energy == 3 * 1.25);
    Mat3 expected = Mat3::Zero();
    expected(0, 0) = 3 * 3.0;
    expected(1, 1) = 3 * 0.75;
    CHECK(sum.virial.diagonal() == expected.diagonal());
    CHECK(static_cast<const State&>(state).forces().col(0) == Vec3(-3.0, 1.5, 0.0));
    CHECK(static_cast<const State&>(state).forces().col(1) == Vec3(0.0, 0.0, 0.0));
    CHECK(static_cast<const State&>(state).forces().col(3) == Vec3(3.0, -1.5, 0.0));
}

TEST_CASE("the sum replaces old forces, and a pair at the cutoff does not count") {
    State state(2);
    state.write_forces().setConstant(7.0);
    const Counting pair;
    // r^2 = 1.25; two neighbouring cutoffs, whose squares are below and above it.
    const double above = std::sqrt(1.25);
    const double below = std::nextafter(above, 0.0);
    REQUIRE(below * below <= 1.25);
    REQUIRE(above * above > 1.25);
    CHECK(sum_pairs<Request::forces_and_energy>(pair, Row(), below, state).potential_energy == 0.0);
    CHECK(static_cast<const State&>(state).forces().isZero(0.0));
    CHECK(pair.calls == 0);
    CHECK(sum_pairs<Request::forces_and_energy>(pair, Row(), above, state).potential_energy == 1.25);
    CHECK(pair.calls == 2);
}

TEST_CASE("the sum does not care where a part ends") {
    // With all atoms inside the cutoff, U = sum over pairs of (i - j)^2 + 1/4.
    for (const Index atoms : {1, 2, 3, 64, 255, 600}) {
        State state(atoms);
        const Evaluation sum = sum_pairs<Request::forces_and_energy>(Counting(), Row(), 1e3, state);
        const double n = static_cast<double>(atoms);
        CHECK(sum.potential_energy == n * n * (n * n - 1.0) / 12.0 + 0.25 * n * (n - 1.0) / 2.0);
        CHECK(static_cast<const State&>(state).forces().col(atoms - 1)[0] == 3.0 * n * (n - 1.0) / 2.0);
    }
}

TEST_CASE("a sum that does not depend on the order counts both sides of every pair, too") {
    State state(5);
    constexpr Request exact{.energy = true, .order_independent = true};
    const Evaluation sum = sum_pairs<exact>(Counting(), Row(), 10.0, state);
    CHECK(sum.potential_energy == 4 * 1.25 + 3 * 4.25 + 2 * 9.25 + 16.25);
    CHECK(static_cast<const State&>(state).forces().col(0) == Vec3(-30.0, 6.0, 0.0));
    CHECK(static_cast<const State&>(state).forces().col(2) == Vec3(0.0, 0.0, 0.0));
    CHECK(static_cast<const State&>(state).forces().col(4) == Vec3(30.0, -6.0, 0.0));
}

TEST_CASE("a pair that comes once counts for both of its atoms, also where these are of two parts") {
    constexpr Request exact{.energy = true, .order_independent = true};
    for (const Index atoms : {2, 5, 64, 255}) {
        State both_sides(atoms);
        State once(atoms);
        const Evaluation expected = sum_pairs<exact>(Counting(), Row(), 10.0, both_sides);
        const Counting pair;
        const Evaluation sum = sum_pairs<exact>(pair, Row{.all_once = true}, 10.0, once);
        CHECK(sum.potential_energy == expected.potential_energy);
        CHECK(sum.virial == expected.virial);
        CHECK(static_cast<const State&>(once).forces() == static_cast<const State&>(both_sides).forces());
        State floating(atoms);
        sum_pairs<Request::forces>(Counting(), Row{.all_once = true}, 10.0, floating);
        CHECK(static_cast<const State&>(floating).forces() == static_cast<const State&>(both_sides).forces());
    }
}

TEST_CASE("the sum of forces alone returns zeros") {
    State state(5);
    const Evaluation sum = sum_pairs<Request::forces>(Counting(), Row(), 10.0, state);
    CHECK(sum.potential_energy == 0.0);
    CHECK(sum.virial == Mat3::Zero());
    CHECK(static_cast<const State&>(state).forces().col(0) == Vec3(-30.0, 6.0, 0.0));
}
