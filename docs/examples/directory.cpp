// A run with a directory: files, checkpoints, a trajectory. It stops after an hour, or when it is killed; started
// again, it goes on to the same end.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <ljmd/ljmd.hpp>

int main(int, char** arguments) {
    const ljmd::Index steps = arguments[1] != nullptr ? std::atol(arguments[1]) : 20000;
    ljmd::FluidSpec argon{.start = ljmd::LatticeStart{.lattice = ljmd::Lattice::fcc, .cells = 6},
                          .density = 0.8442,
                          .temperature = 0.722};
    argon.stages = {{.name = "production", .time_step = 0.004, .steps = steps, .sample = true}};
    const std::filesystem::path directory = "runs/argon";
    const ljmd::Interruption after_an_hour(3600.0);
    const bool begun = std::filesystem::exists(directory / "run.json");
    try {
        const ljmd::RunResult result =
            begun ? ljmd::resume_in_directory(directory, {.interruption = after_an_hour})
                  : ljmd::run_in_directory(
                        argon, directory,
                        {.files = {.title = "Liquid argon", .trajectory = ljmd::TrajectoryOutput{.every = 100}},
                         .interruption = after_an_hour});
        const ljmd::Estimate pressure = result.observable("pressure").estimate.value();
        std::cout << (begun ? "resumed" : "begun") << ": pressure = " << pressure.mean << " +- "
                  << pressure.standard_error << '\n';
    } catch (const ljmd::Interrupted& stopped) {
        std::cout << stopped.what() << '\n';
    }
}
