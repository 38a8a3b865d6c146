#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <cmath>
#include <map>
#include <string>
#include "catch.hpp"

#include "execution/test_execution.hpp"
#include "forces/every_potential.hpp"
#include "forces/pair_force_field.hpp"
#include "forces/simd/pair_kernel.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

struct Evaluated {
    Eigen::Matrix3Xd forces;  ///< by id
    Evaluation sums;
};

Evaluated evaluated(const PairPotential& potential, const char* search, const ExecutionOptions& options, State state,
                    Request request = Request::forces_and_energy) {
    PairForceField force_field(potential, make_pair_search(search, 0.3), Execution(options));
    const Evaluation sums = force_field.evaluate(state, request);
    return {test::by_id(state, state.forces()), sums};
}

double rms(const Eigen::Matrix3Xd& f) {
    return f.norm() / std::sqrt(static_cast<double>(f.cols()));
}

/// 500 atoms of a dense fluid, no whole number of blocks, and far from the edge of a cell.
State fluid(int threads = default_thread_count()) {
    return test::shaken_crystal(5, 0.8442, 0.1, 7, test::with_threads(threads));
}

/// Forces, to a part of their root mean square, and energy and virial, to a part of themselves, of every potential on
/// every SIMD level.
void check_against_scalar_sum(Precision precision, double tolerance_of_forces, double tolerance_of_sums) {
    for (const PairPotential& potential : test::every_potential()) {
        const Evaluated expected = evaluated(potential, "cells", {}, fluid());
        for (const SimdLevel level : usable_simd_levels()) {
            CAPTURE(potential.formula(), potential.truncation(), name(level));
            const Evaluated found =
                evaluated(potential, "verlet-list", {.simd = level, .precision = precision}, fluid());
            CHECK((found.forces - expected.forces).cwiseAbs().maxCoeff() < tolerance_of_forces * rms(expected.forces));
            CHECK(found.sums.potential_energy == Approx(expected.sums.potential_energy).epsilon(tolerance_of_sums));
            CHECK((found.sums.virial - expected.sums.virial).norm() < tolerance_of_sums * expected.sums.virial.norm());
        }
    }
}

}  // namespace

TEST_CASE("kernels have vectors as wide as the registers of their level, whatever the compiler") {
    const std::map<std::string, int> bytes{
        {"x86-64-v2", 16}, {"x86-64-v3", 32}, {"x86-64-v4", 64}, {"x86-64-v4-256", 32}, {"x86-64-v4-intel", 64}};
    for (const SimdLevel level : simd::levels) {  // of processors that this one is not, too
        if (const auto known = bytes.find(std::string(name(level))); known != bytes.end()) {
            CAPTURE(name(level));
            const auto& [in_double, mixed] = pair_kernels(level).row_shapes;
            CHECK(in_double.atoms * in_double.others * 8 == known->second);
            CHECK(mixed.atoms * mixed.others * 4 == known->second);
        }
    }
}

TEST_CASE("kernels of every SIMD level in double give what the scalar sum gives, for every potential") {
    check_against_scalar_sum(Precision::double_precision, 1e-13, 1e-13);
}

TEST_CASE("kernels of every SIMD level in mixed precision give what the scalar sum gives, to single precision") {
    check_against_scalar_sum(Precision::mixed, 1e-5, 1e-6);
}

TEST_CASE("kernels give the same forces to the last bit with and without energy, for any number of threads") {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    for (const SimdLevel level : usable_simd_levels()) {
        for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
            CAPTURE(name(level), name(precision));
            const Evaluated one = evaluated(potential, "verlet-list", {.simd = level, .precision = precision}, fluid());
            CHECK(evaluated(potential, "verlet-list", {.simd = level, .precision = precision}, fluid(), Request::forces)
                      .forces == one.forces);
            for (const int threads : {2, 3, 8}) {
                const Evaluated several =
                    evaluated(potential, "verlet-list", {.simd = level, .precision = precision}, fluid(threads));
                CHECK(several.forces == one.forces);
                CHECK(several.sums.potential_energy == one.sums.potential_energy);
                CHECK(several.sums.virial == one.sums.virial);
            }
        }
    }
}

TEST_CASE("kernels give the forces on ghosts to their owners, whatever tiles the box is cut into") {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    const State large = test::shaken_crystal(16, 0.8442, 0.1, 7);  // 16384 atoms, three tiles and more
    const State small = test::shaken_crystal(3, 0.6, 0.1, 9);      // edges of 5.6, atoms that are ghosts of themselves
    for (const State& fluid : {large, small}) {
        const Evaluated expected = evaluated(potential, "cells", {}, fluid);
        for (const SimdLevel level : usable_simd_levels()) {
            CAPTURE(fluid.count(), name(level));
            const Evaluated found = evaluated(potential, "verlet-list", {.simd = level}, fluid);
            CHECK((found.forces - expected.forces).cwiseAbs().maxCoeff() < 1e-13 * rms(expected.forces));
            CHECK(found.sums.potential_energy == Approx(expected.sums.potential_energy).epsilon(1e-13));
            CHECK((found.sums.virial - expected.sums.virial).norm() < 1e-13 * expected.sums.virial.norm());
            const Evaluated mixed =
                evaluated(potential, "verlet-list", {.simd = level, .precision = Precision::mixed}, fluid);
            CHECK((mixed.sums.virial - expected.sums.virial).norm() < 1e-6 * expected.sums.virial.norm());
        }
    }
}

TEST_CASE("kernels handle atoms without neighbours, and blocks that are not full") {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    for (const Index atoms : {1, 2, 63, 64, 65, 130}) {
        const State gas = test::random_state(atoms, Box(Vec3::Constant(60.0)), 11);
        const Evaluated expected = evaluated(potential, "all-pairs", {}, gas);
        for (const SimdLevel level : usable_simd_levels()) {
            for (const Precision precision : {Precision::double_precision, Precision::mixed}) {
                CAPTURE(atoms, name(level), name(precision));
                const Evaluated found =
                    evaluated(potential, "verlet-list", {.simd = level, .precision = precision}, gas);
                const double tolerance = precision == Precision::mixed ? 1e-4 : 1e-12;
                CHECK((found.forces - expected.forces).norm() <= tolerance * expected.forces.norm());
                CHECK(found.sums.potential_energy ==
                      Approx(expected.sums.potential_energy).epsilon(tolerance).margin(0));
                CHECK((found.sums.virial - expected.sums.virial).norm() <= tolerance * expected.sums.virial.norm());
            }
        }
    }
}

TEST_CASE("the error of mixed precision does not grow with the box") {
    const PairPotential potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    // Two atoms in the far corner of boxes: single-precision coordinates would leave an error of 1e-3 in the last.
    for (const double edge : {10.0, 100.0, 1000.0, 10000.0}) {
        const Vec3 corner = Vec3::Constant(0.99 * edge);
        const State pair = test::state_of({corner, corner + Vec3(0.9, 0.3, 0.2)}, Box(Vec3::Constant(edge)));
        const Evaluated exact = evaluated(potential, "all-pairs", {}, pair);
        const Evaluated mixed = evaluated(potential, "verlet-list", {.precision = Precision::mixed}, pair);
        const double unit = FixedPoint(pair.box(), 2.0 * 2.8).unit();
        CAPTURE(edge, unit);
        CHECK((mixed.forces - exact.forces).norm() < (1e-6 + 40.0 * unit) * exact.forces.norm());
        CHECK(unit < 4e-8 * std::max(edge, 100.0) / 10.0);
    }
}

#if defined(__x86_64__)
TEST_CASE("kernels take numbers below the normal range for zero, and leave the arithmetic as they found it") {
    // At r = 1e5 the force, 24 r^-7, is 2e-34, but 48 r^-8 on the way to it is 5e-39, below single precision's 1.2e-38.
    const PairPotential potential = PairPotential::lennard_jones("cut", {1.2e5, 0.0});
    const Vec3 first = Vec3::Constant(1.0);
    const State pair = test::state_of({first, first + Vec3(1e5, 0.0, 0.0)}, Box(Vec3::Constant(4e5)));
    constexpr unsigned flags = 0x3f;  // what has happened, which may change
    for (const SimdLevel level : usable_simd_levels()) {
        CAPTURE(name(level));
        const unsigned before = _mm_getcsr() & ~flags;
        CHECK(evaluated(potential, "verlet-list", {.simd = level, .precision = Precision::mixed}, pair).forces.norm() ==
              0.0);
        CHECK(evaluated(potential, "verlet-list", {.simd = level}, pair).forces(0, 0) ==
              Approx(24.0 * std::pow(1e5, -7)).epsilon(1e-12).margin(0));
        CHECK((_mm_getcsr() & ~flags) == before);
    }
}
#endif
