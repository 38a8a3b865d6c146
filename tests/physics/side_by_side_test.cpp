// Simulations with other threads, SIMD levels and precisions in one process change no bit of each other.
#include <thread>
#include <utility>
#include <vector>
#include "catch.hpp"

#include "observables/structure/order_parameter.hpp"
#include "observables/structure/pair_histogram.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;

namespace {

constexpr Index cells = 6;  // 864 atoms: seven blocks for threads to share
constexpr Index steps = 300;

struct End {
    Eigen::Matrix3Xd positions;
    Eigen::Matrix3Xd velocities;
    double potential_energy;
    double kinetic_energy;
    double order;
    std::vector<Index> pairs;
};

/// A crystal that melts.
End end_of_run(const ExecutionOptions& options) {
    const Execution execution(options);
    State state = test::crystal(cells, 0.8442, execution);
    draw_velocities(state, 1.44, 3);
    PairForceField force_field(PairPotential::lennard_jones("cut", {2.5, 0.0}), make_pair_search("verlet-list", 0.3),
                               execution);
    test::advance(state, force_field, 0.005, steps);
    const Evaluation last = force_field.evaluate(state, Request::forces_and_energy);
    return {test::unwrapped_by_id(state),
            test::by_id(state, state.velocities()),
            last.potential_energy,
            kinetic_energy(state),
            TranslationalOrder(Lattice::fcc, cells, cells)(state),
            pair_histogram(state, 2.5, 50)};
}

void check_equal(const End& a, const End& b) {
    CHECK(a.positions == b.positions);
    CHECK(a.velocities == b.velocities);
    CHECK(a.potential_energy == b.potential_energy);
    CHECK(a.kinetic_energy == b.kinetic_energy);
    CHECK(a.order == b.order);
    CHECK(a.pairs == b.pairs);
}

}  // namespace

TEST_CASE("two fluids that run at once, with other settings each, have the bits that each has alone") {
    const SimdLevel highest = usable_simd_levels().back();
    const std::vector<std::pair<ExecutionOptions, ExecutionOptions>> pairs{
        {{.threads = 1, .simd = SimdLevel::portable}, {.threads = 2, .simd = highest}},
        {{.threads = 3, .simd = highest, .precision = Precision::mixed}, {.threads = 2, .simd = highest}},
        {{.threads = 2, .simd = SimdLevel::portable, .precision = Precision::mixed},
         {.threads = 1, .simd = highest, .precision = Precision::mixed}}};
    for (const auto& pair : pairs) {
        const ExecutionOptions& one = pair.first;
        const ExecutionOptions& other = pair.second;
        CAPTURE(one.threads, name(one.simd), name(one.precision));
        CAPTURE(other.threads, name(other.simd), name(other.precision));
        const End one_alone = end_of_run(one);
        const End other_alone = end_of_run(other);
        End one_beside{};
        End other_beside{};
        std::thread first([&] { one_beside = end_of_run(one); });
        std::thread second([&] { other_beside = end_of_run(other); });
        first.join();
        second.join();
        check_equal(one_beside, one_alone);
        check_equal(other_beside, other_alone);
        if (one.precision != other.precision) {
            CHECK(one_alone.positions != other_alone.positions);
        }
    }
}
