#include <cmath>
#include "catch.hpp"

#include "judge/point_judgement.hpp"
#include "judge/shaken_liquid.hpp"
#include "judge/summed_pairs.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::StartsWith;

TEST_CASE("mistakes that change energy, virial and forces alike are named, in every truncation") {
    for (const char* truncation : {"cut", "shifted", "force-shifted", "switched"}) {
        INFO(truncation);
        const Fluid fluid = shaken_liquid(truncation, PairPotential::takes_tail(truncation));
        const ExpectedPoint expected = expected_point_of(fluid);
        const double half = 0.5 * fluid.edges.minCoeff();
        const SummedPairs pairs(fluid.positions, fluid.edges, half);
        const auto with = [&](const PairPotential& potential, const SummedPairs::Assumed& assumed) {
            return first_diagnosis(fluid, point_with(expected, pairs.sums(potential, assumed)));
        };
        CHECK(with(fluid.potential, {}).empty());
        CHECK_THAT(with(fluid.potential, {.epsilon = 1.0 + 1e-8}), StartsWith("epsilon off"));
        CHECK_THAT(with(fluid.potential, {.epsilon = 0.9}),
                   StartsWith("epsilon off") && Catch::Contains("epsilon of 0.9,"));
        const auto missing = [&](const SummedPairs::MissedImages& missed, bool alone = false) {
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

TEST_CASE("forces of a wrong formula are named, with their virial or the right one") {
    for (const char* truncation : {"cut", "force-shifted"}) {
        const Fluid fluid = shaken_liquid(truncation, PairPotential::takes_tail(truncation));
        const ExpectedPoint expected = expected_point_of(fluid);
        const SummedPairs pairs(fluid.positions, fluid.edges, 2.2);
        const auto said = [&](int power, bool with_virial) {
            PairSums sums = pairs.sums_of([&](const SummedPairs::Pair& pair) {
                const PairTerm<double> term = fluid.potential(pair.distance);
                return PairTerm<double>{term.u, term.w * std::pow(pair.distance, power)};
            });
            if (!with_virial) sums.virial = expected.sums.virial;
            return first_diagnosis(fluid, point_with(expected, sums));
        };
        for (const bool with_virial : {true, false}) {
            CHECK_THAT(said(1, with_virial), StartsWith("forces: r_ij is not divided by r"));
            CHECK_THAT(said(2, with_virial), StartsWith("forces: they are r^2 times too large"));
            CHECK_THAT(said(-1, with_virial), StartsWith("forces: they are divided by r once too often"));
            CHECK_THAT(said(-2, with_virial), StartsWith("forces: they are divided by r^2 once too often"));
        }
    }
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    const SummedPairs pairs(fluid.positions, fluid.edges, 2.2);
    for (const auto& [a, b, words] :
         {std::tuple(24.0, -24.0, "forces: a 2 is forgotten"), std::tuple(48.0, -48.0, "forces: a 1/2 is forgotten"),
          std::tuple(48.0, 24.0, "forces: the sign of r^-6 is wrong")}) {
        const PairSums sums = pairs.sums_of([&, a = a, b = b](const SummedPairs::Pair& pair) {
            const double s6 = std::pow(pair.distance, -6);
            return PairTerm<double>{fluid.potential(pair.distance).u,
                                    (a * s6 * s6 + b * s6) / (pair.distance * pair.distance)};
        });
        CHECK_THAT(first_diagnosis(fluid, point_with(expected, sums)), StartsWith(words));
    }
}

TEST_CASE("parts that are cut off in another way are named") {
    for (const auto& [ours, theirs] : {std::pair("force-shifted", "cut"), std::pair("force-shifted", "shifted"),
                                       std::pair("cut", "force-shifted"), std::pair("switched", "shifted")}) {
        INFO(ours << ", " << theirs);
        const Fluid fluid = shaken_liquid(ours, PairPotential::takes_tail(ours));
        const ExpectedPoint expected = expected_point_of(fluid);
        const SummedPairs pairs(fluid.positions, fluid.edges, 2.2);
        const PairSums other = pairs.sums(PairPotential::lennard_jones(theirs, {2.2, 1.8}));
        const auto said = [&](bool energy, bool forces) {
            PairSums sums = forces ? other : expected.sums;
            sums.potential_energy = (energy ? other : expected.sums).potential_energy;
            return first_diagnosis(fluid, point_with(expected, sums));
        };
        CHECK_THAT(said(true, true), StartsWith("truncation: energy, virial and forces are those of a potential"));
        CHECK_THAT(said(false, true), StartsWith("truncation: forces and virial are those"));
        CHECK_THAT(said(true, false), StartsWith("truncation: the energy is that"));
    }
}

TEST_CASE("another box, and a loop that begins one too late, are named") {
    for (const char* truncation : {"cut", "force-shifted"}) {
        const Fluid fluid = shaken_liquid(truncation, PairPotential::takes_tail(truncation));
        const ExpectedPoint expected = expected_point_of(fluid);
        const SummedPairs pairs(fluid.positions, fluid.edges, 0.5 * fluid.edges.minCoeff());
        const auto said = [&](const Vec3& longer) {
            const Vec3 by = longer.cwiseProduct(fluid.edges);
            return first_diagnosis(fluid, point_with(expected, pairs.with_longer_edges(by).sums(fluid.potential)));
        };
        CHECK(said(Vec3::Zero()).empty());
        CHECK_THAT(said(Vec3::Constant(0.001)),
                   StartsWith("edges of the box") && Catch::Contains("edges are 1.001 times"));
        CHECK_THAT(said(Vec3(0.0, 0.0, -0.002)),
                   StartsWith("edges of the box") && Catch::Contains("edge z is 0.998 times"));
        CHECK_THAT(first_diagnosis(
                       fluid, point_with(expected, pairs.sums_of([&](const SummedPairs::Pair& pair) {
                           return pair.j == pair.i + 1 ? PairTerm<double>{0.0, 0.0} : fluid.potential(pair.distance);
                       }))),
                   StartsWith("neighbouring ids"));
    }
}

TEST_CASE("forces alone, or energy and virial alone, are enough to know a mistake, one number is not") {
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    const SummedPairs pairs(fluid.positions, fluid.edges, 0.5 * fluid.edges.minCoeff());
    const PairSums wrong = pairs.sums(fluid.potential, {.epsilon = 1.25});
    CHECK_THAT(first_diagnosis(fluid, {.forces = wrong.forces}), StartsWith("epsilon off"));
    CHECK_THAT(first_diagnosis(
                   fluid, {.potential_energy = wrong.potential_energy + expected.tail_energy, .virial = wrong.virial}),
               StartsWith("epsilon off"));
    CHECK(first_diagnosis(fluid, {.potential_energy = wrong.potential_energy + expected.tail_energy}).empty());
}
