#include <cmath>
#include "catch.hpp"

#include "judge/point_judgement.hpp"
#include "judge/shaken_liquid.hpp"
#include "judge/summed_pairs.hpp"

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
    const SummedPairs pairs(fluid.positions, fluid.edges, 2.2);
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
    CHECK_THAT(energy(0.25 * (u - expected.tail_energy) + expected.tail_energy), StartsWith("quarter of the energy"));
    CHECK_THAT(energy(u - 2.0 * expected.tail_energy), StartsWith("tail of the wrong sign"));
    CHECK_THAT(energy(u - 0.5 * expected.tail_energy), StartsWith("half the tail"));
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
    double of_atoms = 0.0;
    for (std::size_t i = 0; i < fluid.positions.size(); ++i) {
        of_atoms += fluid.positions[i].dot(expected.sums.forces[i]);
    }
    CHECK_THAT(virial(of_atoms), StartsWith("virial: it is the sum of r_i . f_i over atoms"));
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

TEST_CASE("a wrong kinetic energy is named, with what follows from it") {
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    const auto said = [&](double factor, bool follows) {
        ExpectedPoint with = expected;
        with.kinetic_energy *= factor;
        PointAnswer answer = right_point(follows ? with : expected);
        answer.kinetic_energy = with.kinetic_energy;
        const auto words = diagnose_point(fluid, expected, answer, tolerance_of_diagnosis);
        return words.size() == 1 ? words[0] : std::to_string(words.size());
    };
    CHECK(said(2.0, false) == "kinetic energy: twice as large; K = sum m v^2/2");
    CHECK(said(2.0, true) ==
          "kinetic energy: twice as large; K = sum m v^2/2; the temperature and the pressure with it are wrong, too");
    CHECK_THAT(said(0.5, true), StartsWith("kinetic energy: half as large"));
    CHECK_THAT(said(1.0 / 108.0, false), StartsWith("kinetic energy: it is divided by the number of atoms"));
}

TEST_CASE("parts of a pressure that have another factor are named, and tails of another formula") {
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    const double k = 2.0 * expected.kinetic_energy / (3.0 * expected.volume);
    const double w = expected.sums.virial / (3.0 * expected.volume);
    const double tail = expected.tail_pressure;
    const double density = 108.0 / expected.volume;
    const double x = std::pow(2.2, -3);
    const double unit = 16.0 / 3.0 * M_PI * density * density;
    for (const auto& [value, words] :
         {std::pair(0.5 * k + w + tail, "pressure: it has K,"), std::pair(2.0 * k + w + tail, "pressure: it has 4 K,"),
          std::pair(3.0 * (k + w) + tail, "pressure: it is (2 K + W)/V,"),
          std::pair(k + 3.0 * w + tail, "pressure: W is divided by V"),
          std::pair(3.0 * k + w + tail, "pressure: 2 K is divided by V"),
          std::pair(k + w - tail, "tail of the wrong sign"),
          std::pair(k + w + unit * (x * x * x / 3.0 - x), "formula of the tail: rc^-9 has 1/3"),
          std::pair(k + w + unit * (x * x * x - x), "formula of the tail: rc^-9 has no")}) {
        PointAnswer answer = right_point(expected);
        answer.pressure = value;
        CHECK_THAT(first_diagnosis(fluid, answer), StartsWith(words));
    }
}

TEST_CASE("a potential that should be shifted and is not is named") {
    const Fluid fluid = shaken_liquid("shifted", false);
    const ExpectedPoint expected = expected_point_of(fluid);
    PointAnswer answer = right_point(expected);
    const SummedPairs pairs(fluid.positions, fluid.edges, 2.2);
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
