// The number of threads changes no bit of a run: lists, ghosts, forces, sums and motion alike.
#include <catch2/catch.hpp>

#include "core/thread_guard.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

struct Run {
    Eigen::Matrix3Xd positions;
    Eigen::Matrix3Xd velocities;
    Evaluation last;
};

Run run_with(int threads, Precision precision, const std::string& search, const std::string& integrator) {
    const test::ThreadGuard guard(threads);
    State state = test::crystal(6, 0.8442);
    draw_velocities(state, 1.44, 3);
    const PairArithmetic arithmetic{default_simd_level(), precision};
    PairForceField force_field(PairPotential::lennard_jones("cut", {2.5, 0.0}), make_pair_search(search, 0.3),
                               arithmetic);
    test::advance(state, force_field, 0.005, 60, integrator);
    Run run{test::unwrapped_by_id(state), test::by_id(state, state.velocities()), {}};
    run.last = force_field.evaluate(state, Request::forces_and_energy);
    return run;
}

void check_same_bits(Precision precision, const std::string& search, const std::string& integrator) {
    CAPTURE(name(precision), search, integrator);
    const Run one = run_with(1, precision, search, integrator);
    for (const int threads : {2, 3, 8}) {
        const Run several = run_with(threads, precision, search, integrator);
        CHECK(several.positions == one.positions);
        CHECK(several.velocities == one.velocities);
        CHECK(several.last.potential_energy == one.last.potential_energy);
        CHECK(several.last.virial == one.last.virial);
    }
}

}  // namespace

TEST_CASE("60 steps of a melting crystal of 864 atoms are the same bits on 1, 2, 3 and 8 threads") {
    check_same_bits(Precision::double_precision, "verlet-list", "velocity-verlet");
    check_same_bits(Precision::mixed, "verlet-list", "velocity-verlet");
    check_same_bits(Precision::double_precision, "cells", "leapfrog");
    check_same_bits(Precision::double_precision, "verlet-list", "bit-reversible");
}
