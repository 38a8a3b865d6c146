#include "ljmd/compare/judge/point_judgement.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "ljmd/compare/point_comparison.hpp"
#include "ljmd/forces/pair_force_field.hpp"
#include "ljmd/model/velocities.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;
using Catch::Matchers::StartsWith;

namespace {

constexpr double tolerance = 1e-11;

Fluid liquid(const std::string& truncation = "cut", bool tail = true) {
    State state = test::crystal(3, 0.8442);
    draw_velocities(state, 0.9, 5);
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {  // away from the sites, the same everywhere
        const auto k = static_cast<double>(i);
        r.col(i) = state.snapped(r.col(i) + 0.08 * Vec3(std::sin(3.1 * k), std::sin(5.3 * k), std::sin(7.7 * k)));
    }
    state.wrap();
    return fluid_of(state, PairPotential::lennard_jones(truncation, {2.2, 1.8}), tail);
}

ExpectedPoint expected_of(const Fluid& fluid) {
    PairForceField force_field(fluid.potential, make_pair_search("all-pairs", 0.3));
    return expected_point(fluid, point_of(fluid, force_field));
}

PointAnswer right_answer(const ExpectedPoint& expected) {
    return {.potential_energy = expected.potential_energy(),
            .kinetic_energy = expected.kinetic_energy,
            .temperature = expected.temperature(),
            .virial = expected.sums.virial,
            .pressure = expected.pressure(),
            .forces = expected.sums.forces};
}

/// The answer of an engine that makes these sums.
PointAnswer answer_of(const ExpectedPoint& expected, const PairSums& sums) {
    PointAnswer answer = right_answer(expected);
    answer.potential_energy = sums.potential_energy + expected.tail_energy;
    answer.virial = sums.virial;
    answer.pressure.reset();
    answer.forces = sums.forces;
    return answer;
}

std::string first(const Fluid& fluid, const PointAnswer& answer) {
    const auto words = diagnose_point(fluid, expected_of(fluid), answer, tolerance);
    return words.empty() ? "" : words.front();
}

}  // namespace

TEST_CASE("a right answer has no diagnosis, and passes in all its parts") {
    for (const char* truncation : {"cut", "shifted", "force-shifted", "switched"}) {
        const Fluid fluid = liquid(truncation, PairPotential::takes_tail(truncation));
        const ExpectedPoint expected = expected_of(fluid);
        CHECK(diagnose_point(fluid, expected, right_answer(expected), tolerance).empty());
        const auto checks = check_point(expected, right_answer(expected), engine_agreement({}));
        CHECK(checks.size() == 7);
        for (const Check& check : checks) {
            CHECK(check.passed());
        }
    }
    CHECK(check_point(expected_of(liquid()), {}, engine_agreement({})).empty());
}

TEST_CASE("mistakes that change energy, virial and forces alike are named, in every truncation") {
    for (const char* truncation : {"cut", "shifted", "force-shifted", "switched"}) {
        INFO(truncation);
        const Fluid fluid = liquid(truncation, PairPotential::takes_tail(truncation));
        const ExpectedPoint expected = expected_of(fluid);
        const double half = 0.5 * fluid.edges.minCoeff();
        const NearPairs pairs(fluid.positions, fluid.edges, half);
        const auto with = [&](const PairPotential& potential, const NearPairs::Assumed& assumed) {
            return first(fluid, answer_of(expected, pairs.sums(potential, assumed)));
        };
        CHECK(with(fluid.potential, {}).empty());
        CHECK_THAT(with(fluid.potential, {.epsilon = 1.0 + 1e-8}), StartsWith("epsilon off"));
        CHECK_THAT(with(fluid.potential, {.epsilon = 0.9}),
                   StartsWith("epsilon off") && Catch::Contains("epsilon of 0.9,"));
        CHECK_THAT(with(fluid.potential, {.images = false}), StartsWith("missing image"));
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

TEST_CASE("forces alone, or energy and virial alone, are enough to know a mistake; one number is not") {
    const Fluid fluid = liquid();
    const ExpectedPoint expected = expected_of(fluid);
    const NearPairs pairs(fluid.positions, fluid.edges, 0.5 * fluid.edges.minCoeff());
    const PairSums wrong = pairs.sums(fluid.potential, {.epsilon = 1.25});
    CHECK_THAT(first(fluid, {.forces = wrong.forces}), StartsWith("epsilon off"));
    CHECK_THAT(
        first(fluid, {.potential_energy = wrong.potential_energy + expected.tail_energy, .virial = wrong.virial}),
        StartsWith("epsilon off"));
    CHECK(first(fluid, {.potential_energy = wrong.potential_energy + expected.tail_energy}).empty());
}

TEST_CASE("mistakes of one number are named") {
    const Fluid fluid = liquid();
    const ExpectedPoint expected = expected_of(fluid);
    const double u = expected.potential_energy();
    const double w = expected.sums.virial;
    const double n = 108.0;
    const NearPairs pairs(fluid.positions, fluid.edges, 2.2);
    const double shift = static_cast<double>(pairs.pairs().size()) * fluid.potential.untruncated(2.2).u;
    const auto energy = [&](double value) {
        PointAnswer answer = right_answer(expected);
        answer.potential_energy = value;
        return first(fluid, answer);
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
        PointAnswer answer = right_answer(expected);
        answer.virial = value;
        return first(fluid, answer);
    };
    CHECK_THAT(virial(-w), StartsWith("virial: the sign"));
    CHECK_THAT(virial(0.5 * w), StartsWith("virial: half"));
    CHECK_THAT(virial(-0.5 * w), StartsWith("virial: minus half"));
    CHECK_THAT(virial(2.0 * w), StartsWith("virial: twice"));
    CHECK_THAT(virial(w / 3.0), StartsWith("virial: a third"));
    CHECK_THAT(virial(w + 2.0 * expected.kinetic_energy), StartsWith("virial: 2 K"));
    CHECK(virial(1.1 * w).empty());
    PointAnswer answer = right_answer(expected);
    answer.temperature = 2.0 * expected.kinetic_energy / (3.0 * n);
    CHECK_THAT(first(fluid, answer), StartsWith("3N against 3N-3: the temperature"));
    answer = right_answer(expected);
    answer.pressure = *answer.pressure - expected.tail_pressure;
    CHECK_THAT(first(fluid, answer), StartsWith("missing tail: the pressure"));
    answer.pressure =
        n * expected.temperature() / expected.volume + w / (3.0 * expected.volume) + expected.tail_pressure;
    CHECK_THAT(first(fluid, answer), StartsWith("3N against 3N-3: the pressure"));
    answer = right_answer(expected);
    for (Vec3& f : answer.forces) {
        f = -f;
    }
    CHECK_THAT(first(fluid, answer), StartsWith("forces: all have the wrong sign"));
    answer.forces.assign(answer.forces.size(), Vec3(1.0, 2.0, 3.0));
    CHECK(first(fluid, answer).empty());
}

TEST_CASE("a potential that should be shifted and is not is named") {
    const Fluid fluid = liquid("shifted", false);
    const ExpectedPoint expected = expected_of(fluid);
    PointAnswer answer = right_answer(expected);
    const NearPairs pairs(fluid.positions, fluid.edges, 2.2);
    answer.potential_energy =
        *answer.potential_energy + static_cast<double>(pairs.pairs().size()) * fluid.potential.untruncated(2.2).u;
    CHECK_THAT(first(fluid, answer), StartsWith("shifted energy: the potential is not shifted"));
}
