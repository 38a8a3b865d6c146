#pragma once

#include <cmath>
#include <string>

#include "compare/point_comparison.hpp"
#include "forces/pair_force_field.hpp"
#include "judge/point_judgement.hpp"
#include "model/velocities.hpp"
#include "physics/liquid.hpp"

namespace ljmd::test {

inline constexpr double tolerance_of_diagnosis = 1e-11;

inline Fluid shaken_liquid(const std::string& truncation = "cut", bool tail = true) {
    State state = crystal(3, 0.8442);
    draw_velocities(state, 0.9, 5);
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {  // away from the sites, the same everywhere
        const auto k = static_cast<double>(i);
        r.col(i) = state.snapped(r.col(i) + 0.08 * Vec3(std::sin(3.1 * k), std::sin(5.3 * k), std::sin(7.7 * k)));
    }
    state.wrap();
    return fluid_of(state, PairPotential::lennard_jones(truncation, {2.2, 1.8}), tail);
}

inline ExpectedPoint expected_point_of(const Fluid& fluid) {
    PairForceField force_field(fluid.potential, make_pair_search("all-pairs", 0.3));
    return expected_point(fluid, point_of(fluid, force_field));
}

inline PointAnswer right_point(const ExpectedPoint& expected) {
    return {.potential_energy = expected.potential_energy(),
            .kinetic_energy = expected.kinetic_energy,
            .temperature = expected.temperature(),
            .virial = expected.sums.virial,
            .pressure = expected.pressure(),
            .forces = expected.sums.forces};
}

/// The answer of an engine that makes these sums.
inline PointAnswer point_with(const ExpectedPoint& expected, const PairSums& sums) {
    PointAnswer answer = right_point(expected);
    answer.potential_energy = sums.potential_energy + expected.tail_energy;
    answer.virial = sums.virial;
    answer.pressure.reset();
    answer.forces = sums.forces;
    return answer;
}

inline std::string first_diagnosis(const Fluid& fluid, const PointAnswer& answer) {
    const auto words = diagnose_point(fluid, expected_point_of(fluid), answer, tolerance_of_diagnosis);
    return words.empty() ? "" : words.front();
}

}  // namespace ljmd::test
