#include "catch.hpp"

#include "compare/openmm.hpp"
#include "compare/small_fluid.hpp"
#include "ljmd/core/errors.hpp"
#include "physics/liquid.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// 108 atoms, most of them still on their lattice.
Fluid warm_crystal() {
    State state = crystal(3, 0.8442);
    draw_velocities(state, 0.7, 5);
    auto force_field = lennard_jones("cut");
    advance(state, force_field, 0.004, 50);
    return fluid_of(state, PairPotential::lennard_jones("cut", {2.5, 2.0}), true);
}

}  // namespace

TEST_CASE("the names of a peer and of its methods are OpenMM's") {
    CHECK(make_openmm_peer(small_fluid(), {})->name() == "OpenMM " + openmm_version() + " (Reference)");
    CHECK(make_openmm_peer(small_fluid(), {.platform = "CPU", .threads = 2})->name() ==
          "OpenMM " + openmm_version() + " (CPU, 2 threads)");
    const auto methods = make_openmm_peer(small_fluid(), {})->methods();
    REQUIRE(methods.size() == 2);
    CHECK(methods[0].name == "VerletIntegrator");
    CHECK(methods[1].ours == std::vector<std::string>{"velocity-verlet"});
}

TEST_CASE("frames begin where the fluid is, synchronised, with either method") {
    const Fluid fluid = warm_crystal();
    const auto peer = make_openmm_peer(fluid, {});
    const PeerPoint point = peer->point();
    CHECK(point.totals.kinetic_energy == Approx(kinetic_energy(fluid)).epsilon(1e-13));
    for (const PeerMethod& method : peer->methods()) {
        INFO(method.name);
        const auto frames = peer->follow(method.name, 0.004, {0, 2});
        REQUIRE(frames.size() == 2);
        CHECK(frames[0].positions == fluid.positions);
        CHECK(frames[0].potential_energy == Approx(point.totals.potential_energy).epsilon(1e-14));
        CHECK(frames[0].kinetic_energy == Approx(kinetic_energy(fluid)).epsilon(1e-12));
        CHECK(frames[1].step == 2);
        // Two steps of free flight, to within what forces add.
        CHECK((frames[1].positions[3] - fluid.positions[3] - 0.008 * fluid.velocities[3]).norm() < 0.01);
        CHECK(frames[1].potential_energy + frames[1].kinetic_energy ==
              Approx(point.totals.potential_energy + kinetic_energy(fluid)).epsilon(1e-3));
    }
}

TEST_CASE("a sample carries totals at every row and positions where they are wanted") {
    const Fluid fluid = warm_crystal();
    const auto peer = make_openmm_peer(fluid, {});
    const auto frames = peer->follow("VerletIntegrator", 0.004, {4, 8});
    std::vector<Index> steps;
    std::vector<Index> with_positions;
    peer->sample(0.004, 9, 2, 4, [&](Index step, const Totals& totals, const std::vector<Vec3>* positions) {
        steps.push_back(step);
        if (positions != nullptr) {
            with_positions.push_back(step);
            const PeerFrame& frame = frames[with_positions.size() - 1];
            CHECK(*positions == frame.positions);
            CHECK(totals.potential_energy == frame.potential_energy);
            CHECK(totals.kinetic_energy == frame.kinetic_energy);
            // The virial is that of the configuration.
            Fluid there = fluid;
            there.positions = frame.positions;
            CHECK(totals.virial == Approx(make_openmm_peer(there, {})->point().totals.virial).epsilon(1e-12));
        }
    });
    CHECK(steps == std::vector<Index>{2, 4, 6, 8});
    CHECK(with_positions == std::vector<Index>{4, 8});
}

TEST_CASE("the CPU platform with one thread repeats itself to the last bit") {
    const Fluid fluid = warm_crystal();
    const auto peer = make_openmm_peer(fluid, {.platform = "CPU"});
    const auto once = peer->follow("VerletIntegrator", 0.004, {50});
    const auto again = peer->follow("VerletIntegrator", 0.004, {50});
    CHECK(once[0].positions == again[0].positions);
    CHECK(peer->seconds(0.004, 10) > 0.0);
}

TEST_CASE("another unit of energy changes the numbers of a peer") {
    const Fluid fluid = warm_crystal();
    const PeerPoint point = make_openmm_peer(fluid, {})->point();
    const PeerPoint other = make_openmm_peer(fluid, {.epsilon = 1.001})->point();
    CHECK(other.totals.potential_energy == Approx(1.001 * point.totals.potential_energy).epsilon(1e-12));
    CHECK(other.totals.virial == Approx(1.001 * point.totals.virial).epsilon(1e-12));
    CHECK(other.tail_energy.value() == Approx(1.001 * point.tail_energy.value()).epsilon(1e-9));
}

TEST_CASE("when OpenMM gives up, its words are told") {
    Fluid fluid = small_fluid();
    fluid.positions[1] = fluid.positions[0] + Vec3(1e-30, 0.0, 0.0);
    const auto peer = make_openmm_peer(fluid, {.platform = "CPU"});
    CHECK_THROWS_AS(peer->follow("VerletIntegrator", 0.004, {10}), PhysicsError);
    CHECK_THROWS_WITH(peer->follow("VerletIntegrator", 0.004, {10}), Contains("OpenMM") && Contains("CPU"));
}
