#include "catch.hpp"

#include "forces/evaluated.hpp"
#include "forces/every_potential.hpp"
#include "ljmd/core/errors.hpp"
#include "potentials/twelve_six.hpp"

using namespace ljmd;

namespace {

using test::evaluate;
using test::Evaluated;
using test::fluid;
using test::rms;

}  // namespace

TEST_CASE("a formula of the program has the bits of the library's where pairs are summed alike, else its digits") {
    const State state = fluid();
    for (const std::string& truncation : PairPotential::truncation_names()) {
        const PairPotential ours = PairPotential::lennard_jones(truncation, test::default_cutoff);
        const PairPotential theirs =
            PairPotential::custom("twelve-six", test::TwelveSix{}, truncation, test::default_cutoff);
        const Evaluated oracle = evaluate({ours, make_pair_search("all-pairs", 0.3)}, state);
        const double scale = rms(oracle.forces);
        for (const std::string& search : pair_search_names()) {
            CAPTURE(truncation, search);
            const Evaluated expected = evaluate({ours, make_pair_search(search, 0.3)}, state);
            const Evaluated found = evaluate({theirs, make_pair_search(search, 0.3)}, state);
            if (search == "verlet-list") {  // kernels sum the library's in another order
                CHECK((found.forces - oracle.forces).colwise().norm().maxCoeff() < 1e-13 * scale);
                CHECK(found.evaluation.potential_energy ==
                      Approx(oracle.evaluation.potential_energy).epsilon(1e-13).margin(1e-11));
                CHECK((found.evaluation.virial - oracle.evaluation.virial).norm() <
                      1e-13 * (oracle.evaluation.virial.norm() + scale * 108.0));
            } else {
                CHECK(found.forces == expected.forces);
                CHECK(found.evaluation.potential_energy == expected.evaluation.potential_energy);
                CHECK(found.evaluation.virial == expected.evaluation.virial);
            }
            State exact = state;
            constexpr Request order_independent{.energy = true, .order_independent = true};
            CHECK(evaluate({theirs, make_pair_search(search, 0.3)}, exact, order_independent).forces ==
                  evaluate({ours, make_pair_search(search, 0.3)}, exact, order_independent).forces);
        }
    }
}

TEST_CASE("a formula of the program has the same bits with any number of threads, and no kernel in mixed precision") {
    const PairPotential theirs =
        PairPotential::custom("twelve-six", test::TwelveSix{}, "shifted", test::default_cutoff);
    const auto evaluated_by = [&](int threads, const std::string& search) {
        State state(fluid().count(), fluid().box(), Execution({.threads = threads}));
        state.write_positions() = fluid().positions();
        return evaluate({theirs, make_pair_search(search, 0.3)}, state);
    };
    for (const std::string& search : pair_search_names()) {
        CAPTURE(search);
        const Evaluated one = evaluated_by(1, search);
        const Evaluated three = evaluated_by(3, search);
        CHECK(three.forces == one.forces);
        CHECK(three.evaluation.potential_energy == one.evaluation.potential_energy);
        CHECK(three.evaluation.virial == one.evaluation.virial);
    }
    CHECK_THROWS_AS(
        PairForceField(theirs, make_pair_search("verlet-list", 0.3), Execution({.precision = Precision::mixed})),
        ContractViolation);
}

TEST_CASE("forces of a formula of the program may be as large as its numbers, in every search") {
    const auto strong = [](const PairDistance<double>& d) {
        const double u = 1e9 * d.inverse_r2;
        return PairTerm<double>{u, 2.0 * u * d.inverse_r2};
    };
    const PairPotential theirs = PairPotential::custom("strong", strong, "cut", test::default_cutoff);
    const Evaluated oracle = evaluate({theirs, make_pair_search("all-pairs", 0.3)}, fluid());
    CHECK(rms(oracle.forces) > 0x1p18);  // beyond the range of sums that are independent of the order
    for (const std::string& search : pair_search_names()) {
        CAPTURE(search);
        const Evaluated found = evaluate({theirs, make_pair_search(search, 0.3)}, fluid());
        CHECK((found.forces - oracle.forces).norm() < 1e-12 * oracle.forces.norm());
    }
}
