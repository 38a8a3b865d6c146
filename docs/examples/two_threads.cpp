// Two simulations at once, each with threads, instruction set and precision of its own: each has the bits that it has
// alone.
#include <ljmd/ljmd.hpp>

#include <cstdlib>
#include <iostream>
#include <thread>

namespace {

ljmd::FluidSpec liquid(double temperature, ljmd::Index steps) {
    ljmd::FluidSpec spec{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 5},
                         .density = 0.8,
                         .temperature = temperature};
    spec.stages = {{.name = "production", .time_step = 0.004, .steps = steps, .sample = true}};
    return spec;
}

}  // namespace

int main(int, char** arguments) {
    const ljmd::Index steps = arguments[1] != nullptr ? std::atol(arguments[1]) : 2000;
    ljmd::Simulation cold(liquid(0.8, steps), ljmd::Execution({.threads = 2}));
    ljmd::Simulation hot(liquid(2.0, steps), ljmd::Execution({.precision = ljmd::Precision::mixed}));
    std::thread other([&hot] { hot.run(); });
    cold.run();
    other.join();

    ljmd::Simulation again(liquid(2.0, steps), ljmd::Execution({.precision = ljmd::Precision::mixed}));
    again.run();
    const bool same = again.state().velocities() == hot.state().velocities();
    std::cout << (same ? "the same bits alone and beside another simulation\n" : "different bits\n");
    return same ? 0 : 1;
}
