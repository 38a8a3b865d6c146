#pragma once

#include <cmath>

#include "compare/made_peer.hpp"
#include "judge/answer.hpp"
#include "judge/exchange.hpp"
#include "judge/judge.hpp"

namespace ljmd::test {

/// The warm crystal with its atoms away from their sites, so that there are forces: the same everywhere.
inline Fluid shaken_crystal() {
    Fluid fluid = warm_crystal();
    for (std::size_t i = 0; i < fluid.positions.size(); ++i) {
        const auto k = static_cast<double>(i);
        fluid.positions[i] += 0.08 * Vec3(std::sin(3.1 * k), std::sin(5.3 * k), std::sin(7.7 * k));
        fluid.positions[i].array() -= fluid.edges.array() * (fluid.positions[i].array() / fluid.edges.array()).floor();
    }
    return fluid_of(state_of(fluid), fluid.potential, fluid.tail);
}

/// 108 atoms that move for some steps at constant energy, force-shifted.
inline Problem small_problem() {
    Stage stage;
    stage.name = "production";
    stage.time_step = 0.004;
    stage.steps = 40;
    return {.fluid = shaken_crystal(),
            .stage = stage,
            .steps_before = 20,
            .trajectory_steps = 10,
            .frames = {0, 1, 10},
            .thermo_every = 5};
}

/// ljmd itself, by the readable sum.
inline OwnSide own_side(const Problem& problem) {
    FluidSpec spec;
    spec.potential = problem.fluid.potential;
    spec.neighbors.method = "all-pairs";
    return {spec, Execution{}, "all-pairs"};
}

}  // namespace ljmd::test
