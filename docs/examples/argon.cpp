// Liquid argon near its triple point, in memory: pressure, energy and g(r), with error bars.
#include <ljmd/ljmd.hpp>

#include <algorithm>
#include <cstdlib>
#include <iostream>

int main(int, char** arguments) {
    const ljmd::Index steps = arguments[1] != nullptr ? std::atol(arguments[1]) : 20000;
    ljmd::FluidSpec argon{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 6},  // 864 atoms
                          .density = 0.8442,
                          .temperature = 0.722,
                          .potential = ljmd::PairPotential::lennard_jones("cut", {.radius = 2.5}),
                          .tail = true};
    argon.stages = {{.name = "equilibration",
                     .time_step = 0.004,
                     .steps = steps / 4,
                     .temperature = 0.722,
                     .thermostat = ljmd::thermostat("stochastic-rescaling", {{"time", 0.1}})},
                    {.name = "production",
                     .time_step = 0.004,
                     .steps = steps,
                     .temperature = 0.722,
                     .sample = true,
                     .thermostat = ljmd::thermostat("stochastic-rescaling", {{"time", 1.0}})}};
    argon.analyses = {ljmd::analysis("rdf")};

    const ljmd::RunResult result = ljmd::Simulation(argon).run();
    for (const char* name : {"temperature", "potential_energy", "pressure"}) {
        const ljmd::ObservableAverage& found = result.observable(name);
        std::cout << found.name << " = " << found.estimate->mean << " +- " << found.estimate->standard_error << ' '
                  << found.unit << '\n';
    }
    const auto& g = result.table("rdf").rows;  // columns r, g
    const auto peak = std::ranges::max_element(g, {}, [](const auto& row) { return row[1]; });
    std::cout << "first peak of g(r): " << (*peak)[1] << " at r = " << (*peak)[0] << " sigma\n";
}
