// A liquid of Mie's potential with a softer core than Lennard-Jones: pressure, energy and g(r), with error bars.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "mie.hpp"

int main(int, char** arguments) {
    const ljmd::Index steps = arguments[1] != nullptr ? std::atol(arguments[1]) : 5000;
    ljmd::FluidSpec liquid{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 5},
                           .density = 0.8,
                           .temperature = 1.0,
                           .potential = ljmd::PairPotential::custom("mie-10-6", Mie(10.0), "cut", {.radius = 2.5}),
                           .tail = true};
    liquid.stages = {{.name = "production",
                      .time_step = 0.004,
                      .steps = steps,
                      .temperature = 1.0,
                      .sample = true,
                      .thermostat = ljmd::thermostat("langevin", {{"time", 0.5}})}};
    liquid.analyses = {ljmd::analysis("rdf")};

    const ljmd::RunResult result = ljmd::Simulation(liquid).run();
    for (const char* name : {"potential_energy", "pressure"}) {
        const ljmd::ObservableAverage& found = result.observable(name);
        std::cout << found.name << " = " << found.estimate->mean << " +- " << found.estimate->standard_error << '\n';
    }
    const auto& g = result.table("rdf").rows;  // columns r, g
    const auto peak = std::ranges::max_element(g, {}, [](const auto& row) { return row[1]; });
    std::cout << "first peak of g(r): " << (*peak)[1] << " at r = " << (*peak)[0] << '\n';
}
