// Equations of state of the Lennard-Jones fluid beside a short simulation: a state, its phase, coexistence, a density
// from a pressure, and second virial coefficients.
#include <ljmd/ljmd.hpp>

#include <cstdlib>
#include <iostream>

int main(int, char** arguments) {
    const ljmd::Index steps = arguments[1] != nullptr ? std::atol(arguments[1]) : 20000;
    const double temperature = 1.0;
    const double density = 0.75;
    const ljmd::EquationOfState thol = ljmd::equation_of_state("thol2016");

    const ljmd::FluidProperties fluid = ljmd::properties(thol, temperature, density);
    std::cout << "U/N = " << fluid.potential_energy << ", p = " << fluid.pressure << ", speed of sound "
              << fluid.speed_of_sound().value() << '\n';
    const ljmd::PhaseOfState phase = ljmd::phase_of_state(thol, temperature, density);
    std::cout << "phase: " << ljmd::name_of(phase.phase) << " (" << phase.lines() << ")\n";
    const ljmd::Coexistence saturated = ljmd::coexistence(thol, temperature).value();
    std::cout << "vapour pressure " << saturated.pressure << ", heat of vaporisation "
              << saturated.heat_of_vaporisation() << '\n';
    std::cout << "density at p = 2: " << ljmd::states_at_pressure(thol, temperature, 2.0).front().state.density << '\n';

    const auto potential = ljmd::PairPotential::lennard_jones("cut", {.radius = 4.0});
    std::cout << "second virial coefficient " << ljmd::untruncated_second_virial_coefficient(potential, temperature)
              << ", by the equation " << ljmd::second_virial_coefficient(thol, temperature) << '\n';

    const auto langevin = ljmd::thermostat("langevin", {{"time", 0.5}});
    ljmd::FluidSpec spec{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 6},
                         .density = density,
                         .temperature = temperature,
                         .potential = potential,
                         .tail = true};
    spec.stages = {{.name = "equilibration",
                    .time_step = 0.004,
                    .steps = steps / 4,
                    .temperature = temperature,
                    .thermostat = langevin},
                   {.name = "production",
                    .time_step = 0.004,
                    .steps = steps,
                    .temperature = temperature,
                    .sample = true,
                    .thermostat = langevin}};
    const ljmd::RunResult result = ljmd::Simulation(spec).run();
    const ljmd::ObservableAverage& energy = result.observable("potential_energy");
    std::cout << "simulated U/N = " << energy.estimate->mean << " +- " << energy.estimate->standard_error << '\n';
}
