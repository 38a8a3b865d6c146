#include <catch2/catch.hpp>
#include <cmath>

#include "compare/judge/shaken_liquid.hpp"
#include "ljmd/compare/judge/near_pairs.hpp"
#include "ljmd/compare/judge/point_judgement.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::StartsWith;

TEST_CASE("mistakes that change energy, virial and forces alike are named, in every truncation") {
    for (const char* truncation : {"cut", "shifted", "force-shifted", "switched"}) {
        INFO(truncation);
        const Fluid fluid = shaken_liquid(truncation, PairPotential::takes_tail(truncation));
        const ExpectedPoint expected = expected_point_of(fluid);
        const double half = 0.5 * fluid.edges.minCoeff();
        const NearPairs pairs(fluid.positions, fluid.edges, half);
        const auto with = [&](const PairPotential& potential, const NearPairs::Assumed& assumed) {
            return first_diagnosis(fluid, point_with(expected, pairs.sums(potential, assumed)));
        };
        CHECK(with(fluid.potential, {}).empty());
        CHECK_THAT(with(fluid.potential, {.epsilon = 1.0 + 1e-8}), StartsWith("epsilon off"));
        CHECK_THAT(with(fluid.potential, {.epsilon = 0.9}),
                   StartsWith("epsilon off") && Catch::Contains("epsilon of 0.9,"));
        const auto missing = [&](const NearPairs::MissedImages& missed, bool alone = false) {
            return with(fluid.potential, {.missed = missed, .each_atom_alone = alone});
        };
        CHECK_THAT(missing({{{true, true}, {true, true}, {true, true}}}),
                   StartsWith("missing image") && Catch::Contains("left out, all others"));
        CHECK_THAT(missing({{{}, {true, true}, {}}}), StartsWith("missing image") && Catch::Contains("out along y,"));
        CHECK_THAT(missing({{{true, false}, {}, {true, true}}}),
                   Catch::Contains("where x_i - x_j < -L/2 for i < j and along z,"));
        CHECK_THAT(missing({{{}, {}, {false, true}}}, true), Catch::Contains("where z_i - z_j > L/2, on atom i,"));
        for (const double s : {0.95, 1.001, 1.05}) {
            INFO(s);
            CHECK_THAT(with(with_cutoff(fluid.potential, 2.2 / s), {.sigma = s}), StartsWith("sigma off"));
            CHECK_THAT(with(fluid.potential, {.sigma = s}),
                       StartsWith("sigma off") && Catch::Contains("cutoff with it"));
        }
        for (const double radius : {2.0, 2.19, 2.4}) {
            INFO(radius);
            CHECK_THAT(with(with_cutoff(fluid.potential, radius), {}), StartsWith("other cutoff"));
        }
    }
}

TEST_CASE("forces alone, or energy and virial alone, are enough to know a mistake, one number is not") {
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    const NearPairs pairs(fluid.positions, fluid.edges, 0.5 * fluid.edges.minCoeff());
    const PairSums wrong = pairs.sums(fluid.potential, {.epsilon = 1.25});
    CHECK_THAT(first_diagnosis(fluid, {.forces = wrong.forces}), StartsWith("epsilon off"));
    CHECK_THAT(first_diagnosis(
                   fluid, {.potential_energy = wrong.potential_energy + expected.tail_energy, .virial = wrong.virial}),
               StartsWith("epsilon off"));
    CHECK(first_diagnosis(fluid, {.potential_energy = wrong.potential_energy + expected.tail_energy}).empty());
}
