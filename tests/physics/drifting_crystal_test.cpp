// A crystal whose centre of mass a thermostat moves: its order, and the motion of its atoms, are those about the
// centre.
#include "catch.hpp"

#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/simulation.hpp"

using namespace ljmd;

namespace {

/// 32 atoms of a crystal at T = 0.3 for 40 tau. Under a Langevin thermostat their centre of mass moves by
/// (2 T time/N * 40 tau)^(1/2) = 0.47 sigma along each axis, and the planes of the crystal lie 0.78 sigma apart.
FluidSpec crystal(const std::string& thermostat_name) {
    FluidSpec spec{.start = LatticeStart{.lattice = Lattice::fcc, .cells = 2},
                   .density = 1.05,
                   .temperature = 0.3,
                   .seed = 5,
                   .potential = PairPotential::lennard_jones("shifted", {.radius = 1.5, .switch_start = 0.0})};
    spec.stages = {{.name = "settle",
                    .time_step = 0.005,
                    .steps = 8000,
                    .temperature = 0.3,
                    .thermostat = thermostat(thermostat_name, {{"time", 0.3}}),
                    .seed = 5}};
    spec.stages.push_back(spec.stages.front());
    spec.stages.back().name = "sampled";
    spec.stages.back().sample = true;
    spec.analyses = {analysis("msd", {{"max_time", 4.0}, {"every", 20}}),
                     analysis("vacf", {{"max_time", 4.0}, {"every", 2}})};
    return spec;
}

}  // namespace

TEST_CASE("a crystal keeps its order, and its atoms do not diffuse, under every thermostat") {
    for (const char* name : {"langevin", "andersen", "stochastic-rescaling"}) {
        CAPTURE(name);
        const RunResult result = Simulation(crystal(name)).run();
        CHECK(result.order_at_sampling.value() == Approx(0.96).margin(0.03));
        // T time/N = 0.0028 is the diffusion of the centre of mass.
        CHECK(std::abs(result.observable("diffusion").estimate.value().mean) < 3e-4);
        CHECK(std::abs(result.observable("diffusion_green_kubo").estimate.value().mean) < 2e-3);
    }
}
