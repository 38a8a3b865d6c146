// Writes small trajectories whose content is known by formula, for readers_test.py to open with other people's tools.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/formats/extended_xyz_writer.hpp"
#include "io/formats/lammps_dump_writer.hpp"
#include "io/formats/trajectory_writer.hpp"

namespace {

using ljmd::Index;
using ljmd::Vec3;

constexpr Index atoms = 5;
constexpr Index frames = 4;

// The same formulas stand in readers_test.py. All values are sums of a few powers of two, so exact.
Vec3 position(Index id, Index frame) {
    const auto k = static_cast<double>(id);
    const auto f = static_cast<double>(frame);
    return {0.5 + 0.75 * k + 1.25 * f, 1.0 + 0.25 * k * k - 2.0 * f, 0.125 * k - 0.5 * f * f};
}

Vec3 velocity(Index id, Index frame) {
    const auto k = static_cast<double>(id);
    const auto f = static_cast<double>(frame);
    return {k - 2.0, 0.5 * f - 0.25 * k, -0.125 * k * f};
}

Vec3 force(Index id, Index frame) {
    const auto k = static_cast<double>(id);
    const auto f = static_cast<double>(frame);
    return {0.25 * k - f, k, -0.5 * f};
}

std::vector<double> energies_of_atoms(Index frame) {
    std::vector<double> energies;
    for (Index id = 0; id < atoms; ++id) {
        energies.push_back(0.25 * static_cast<double>(frame) - 0.5 * static_cast<double>(id));
    }
    return energies;
}

ljmd::State make_state(Index frame, bool bounded) {
    const auto f = static_cast<double>(frame);
    const ljmd::Box box(Vec3(4.0 + 0.5 * f, 5.0, 6.0 - 0.25 * f));
    ljmd::State state(atoms, bounded ? std::optional(box) : std::nullopt);
    for (Index id = 0; id < atoms; ++id) {
        state.write_positions().col(id) = position(id, frame);
        state.write_velocities().col(id) = velocity(id, frame);
    }
    if (bounded) {
        state.wrap();
    }
    for (Index id = 0; id < atoms; ++id) {
        state.write_forces().col(id) = force(id, frame);
    }
    state.mark_forces_current();
    state.reorder(frame % 2 == 0 ? std::vector<Index>{3, 0, 4, 2, 1} : std::vector<Index>{1, 4, 0, 3, 2});
    state.time = 0.25 * f;
    state.step = 50 * frame;
    return state;
}

ljmd::SubstanceUnits argon() {
    constexpr double boltzmann = 1.380649e-23;
    constexpr double dalton = 1.66053906660e-27;
    return {3.405e-10, 119.8 * boltzmann, 39.948 * dalton};
}

void write_trajectory(const std::filesystem::path& path, const std::string& format, bool si, bool velocities,
                      bool bounded, bool forces = false) {
    const ljmd::TrajectoryOptions options{.path = path,
                                          .velocities = velocities,
                                          .forces = forces,
                                          .energies = forces,
                                          .si = si ? std::optional(argon()) : std::nullopt,
                                          .creator_version = "1.2.3",
                                          .author = "Loup Verlet",
                                          .title = "known formulas"};
    const auto writer = ljmd::make_trajectory_writer(format, make_state(0, bounded), options);
    for (Index frame = 0; frame < frames; ++frame) {
        writer->write(make_state(frame, bounded), forces ? energies_of_atoms(frame) : std::vector<double>());
    }
    writer->close();
}

void write_dump(const std::filesystem::path& path) {
    ljmd::OutputFile file(path);
    for (Index frame = 0; frame < frames; ++frame) {
        const std::vector<double> energies = energies_of_atoms(frame);
        ljmd::write_lammps_dump_frame(file, make_state(frame, true),
                                      {.velocities = true, .forces = true, .energies = energies});
    }
    file.close();
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::fputs("usage: write_sample_trajectories FOLDER\n", stderr);
        return 2;
    }
    try {
        const std::filesystem::path folder = arguments[1];
        std::filesystem::create_directories(folder);
        write_trajectory(folder / "reduced.h5md", "h5md", false, true, true);
        write_trajectory(folder / "si.h5md", "h5md", true, true, true);
        write_trajectory(folder / "positions.h5md", "h5md", true, false, true);
        write_trajectory(folder / "unbounded.h5md", "h5md", false, true, false);
        write_trajectory(folder / "reduced.xyz", "xyz", false, true, true);
        write_trajectory(folder / "si.xyz", "xyz", true, true, true);
        write_trajectory(folder / "positions.xyz", "xyz", true, false, true);
        write_trajectory(folder / "unbounded.xyz", "xyz", false, true, false);
        for (const std::string format : {"h5md", "xyz"}) {
            write_trajectory(folder / ("forces." + format), format, false, true, true, true);
            write_trajectory(folder / ("forces-si." + format), format, true, false, true, true);
        }
        write_dump(folder / "forces.lammpsdump");
        ljmd::write_configuration(folder / "final.xyz", make_state(frames - 1, true), true);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "error: %s\n", error.what());
        return 1;
    }
    return 0;
}
