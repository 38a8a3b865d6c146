#include "io/formats/extended_xyz_writer.hpp"
#include "io/formats/trajectory_writer.hpp"

namespace ljmd {

namespace {

void write_xyz_frame(OutputFile& file, const State& state, std::span<const double> energies,
                     const TrajectoryOptions& options) {
    write_extended_xyz_frame(
        file, state, {.velocities = options.velocities, .forces = options.forces, .energies = energies}, options.si);
}

double xyz_bytes(Index atoms, Index frames, const AtomColumns& columns) {
    constexpr double header = 200.0;
    constexpr double number = 20.0;
    constexpr double species_and_id = 8.0;
    const double vectors = 1.0 + (columns.velocities ? 2.0 : 0.0) + (columns.forces ? 1.0 : 0.0);  // momenta, too
    const double numbers = 3.0 * vectors + (columns.energies ? 1.0 : 0.0);
    return static_cast<double>(frames) * (header + (species_and_id + numbers * number) * static_cast<double>(atoms));
}

}  // namespace

/// Extended XYZ, see extended_xyz_writer.hpp for a frame.
TrajectoryFormat xyz() {
    return {.name = "xyz",
            .meaning = "extended XYZ",
            .si_units = "angstrom, ps",
            .is_read = true,
            .make = text_trajectory(write_xyz_frame),
            .bytes = xyz_bytes};
}

}  // namespace ljmd
