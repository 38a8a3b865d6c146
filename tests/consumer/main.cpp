// A program of somebody else that uses an installed ljmd: a run in memory, in a folder that stays empty.
#include <ljmd/engine.hpp>

#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>

int main() {
    // A name that nobody else has: the folder for temporary files belongs to all users.
    std::string name = std::filesystem::temp_directory_path() / "ljmd-consumer-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) {
        std::cerr << "cannot make " << name << '\n';
        return 1;
    }
    const std::filesystem::path folder = name;
    std::filesystem::current_path(folder);

    ljmd::FluidSpec crystal{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 5},
                            .density = 1.0,
                            .temperature = 0.1,
                            .potential = ljmd::PairPotential::lennard_jones("cut", {.radius = 2.5}),
                            .tail = false};
    crystal.stages = {{.name = "production", .time_step = 0.004, .steps = 100, .sample = true}};
    ljmd::Simulation simulation(crystal);
    const ljmd::RunResult result = simulation.run();
    const double energy = simulation.samples().front().values.potential_energy;
    std::cout << "ljmd " << ljmd::build_info().version << ": " << energy
              << " epsilon an atom at the start, temperature " << result.observable("temperature").estimate->mean
              << '\n';
    const bool wrote = !std::filesystem::is_empty(folder);
    std::filesystem::current_path("/");
    std::filesystem::remove_all(folder);
    // Shell n of fcc lies at r^2 = n a^2/2, a = 4^(1/3); those within the cutoff hold 12, 6, 24 and 12 atoms:
    // u = sum over n of 2 m_n (r^-12 - r^-6) = -7.76159.
    return std::abs(energy + 7.76159) < 1e-5 && !wrote ? 0 : 1;
}
