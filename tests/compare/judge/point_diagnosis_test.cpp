#include <catch2/catch.hpp>
#include <cmath>

#include "compare/judge/shaken_liquid.hpp"
#include "ljmd/compare/judge/near_pairs.hpp"
#include "ljmd/compare/judge/point_judgement.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::StartsWith;

TEST_CASE("a right answer has no diagnosis, and passes in all its parts") {
    for (const char* truncation : {"cut", "shifted", "force-shifted", "switched"}) {
        const Fluid fluid = shaken_liquid(truncation, PairPotential::takes_tail(truncation));
        const ExpectedPoint expected = expected_point_of(fluid);
        CHECK(diagnose_point(fluid, expected, right_point(expected), tolerance_of_diagnosis).empty());
        const auto checks = check_point(expected, right_point(expected), engine_agreement({}));
        CHECK(checks.size() == 7);
        for (const Check& check : checks) {
            CHECK(check.passed());
        }
    }
    CHECK(check_point(expected_point_of(shaken_liquid()), {}, engine_agreement({})).empty());
}

TEST_CASE("mistakes of one number are named") {
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    const double u = expected.potential_energy();
    const double w = expected.sums.virial;
    const double n = 108.0;
    const NearPairs pairs(fluid.positions, fluid.edges, 2.2);
    const double shift = static_cast<double>(pairs.pairs().size()) * fluid.potential.untruncated(2.2).u;
    const auto energy = [&](double value) {
        PointAnswer answer = right_point(expected);
        answer.potential_energy = value;
        return first_diagnosis(fluid, answer);
    };
    CHECK_THAT(energy(u - shift), StartsWith("shifted energy: the potential is shifted"));
    CHECK_THAT(energy(u - shift - expected.tail_energy), StartsWith("shifted energy and missing tail"));
    CHECK_THAT(energy(expected.sums.potential_energy), StartsWith("missing tail"));
    CHECK_THAT(energy(u + expected.tail_energy), StartsWith("tail twice"));
    CHECK_THAT(energy(u / n), StartsWith("energy of one atom"));
    CHECK_THAT(energy(2.0 * expected.sums.potential_energy + expected.tail_energy), StartsWith("pairs twice"));
    CHECK_THAT(energy(-u), StartsWith("sign"));
    CHECK_THAT(energy(u + expected.kinetic_energy), StartsWith("total energy"));
    CHECK(energy(u * 1.01).empty());
    const auto virial = [&](double value) {
        PointAnswer answer = right_point(expected);
        answer.virial = value;
        return first_diagnosis(fluid, answer);
    };
    CHECK_THAT(virial(-w), StartsWith("virial: the sign"));
    CHECK_THAT(virial(0.5 * w), StartsWith("virial: half"));
    CHECK_THAT(virial(-0.5 * w), StartsWith("virial: minus half"));
    CHECK_THAT(virial(2.0 * w), StartsWith("virial: twice"));
    CHECK_THAT(virial(w / 3.0), StartsWith("virial: a third"));
    CHECK_THAT(virial(w + 2.0 * expected.kinetic_energy), StartsWith("virial: 2 K"));
    CHECK(virial(1.1 * w).empty());
    PointAnswer answer = right_point(expected);
    answer.temperature = 2.0 * expected.kinetic_energy / (3.0 * n);
    CHECK_THAT(first_diagnosis(fluid, answer), StartsWith("3N against 3N-3: the temperature"));
    answer = right_point(expected);
    answer.pressure = *answer.pressure - expected.tail_pressure;
    CHECK_THAT(first_diagnosis(fluid, answer), StartsWith("missing tail: the pressure"));
    answer.pressure =
        n * expected.temperature() / expected.volume + w / (3.0 * expected.volume) + expected.tail_pressure;
    CHECK_THAT(first_diagnosis(fluid, answer), StartsWith("3N against 3N-3: the pressure"));
    answer = right_point(expected);
    for (Vec3& f : answer.forces) {
        f = -f;
    }
    CHECK_THAT(first_diagnosis(fluid, answer), StartsWith("forces: all have the wrong sign"));
    // Forces of no meaning sum to zero: nothing is known of them.
    for (std::size_t i = 0; i < answer.forces.size(); ++i) {
        answer.forces[i] = Vec3(i % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0);
    }
    CHECK(first_diagnosis(fluid, answer).empty());
    answer = right_point(expected);
    for (Vec3& f : answer.forces) {
        f += Vec3(0.0, 1e-7, 0.0);
    }
    CHECK_THAT(first_diagnosis(fluid, answer), StartsWith("constant force: the same force of 1e-07 along y"));
}

TEST_CASE("a potential that should be shifted and is not is named") {
    const Fluid fluid = shaken_liquid("shifted", false);
    const ExpectedPoint expected = expected_point_of(fluid);
    PointAnswer answer = right_point(expected);
    const NearPairs pairs(fluid.positions, fluid.edges, 2.2);
    answer.potential_energy =
        *answer.potential_energy + static_cast<double>(pairs.pairs().size()) * fluid.potential.untruncated(2.2).u;
    CHECK_THAT(first_diagnosis(fluid, answer), StartsWith("shifted energy: the potential is not shifted"));
}

TEST_CASE("of mistakes with nearly the same energy the one that explains most is named") {
    // A shift of all pairs within the cutoff has nearly the energy of the tail.
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    const double tail = expected.tail_energy;
    const double others = 107.0 / 108.0;
    for (const auto& [factor, words] :
         {std::pair(0.0, "missing tail: the tail correction is left out"), std::pair(2.0, "tail twice"),
          std::pair(others, "tail of N - 1: the tail correction is that of N - 1 atoms, or"),
          std::pair(others * others, "tail of N - 1: the tail correction is that of N - 1 atoms at"),
          std::pair(1.0 / 108.0, "tail of one atom")}) {
        PointAnswer answer = right_point(expected);
        answer.potential_energy = expected.sums.potential_energy + factor * tail;
        CHECK_THAT(first_diagnosis(fluid, answer), Catch::Matchers::StartsWith(words));
    }
}
