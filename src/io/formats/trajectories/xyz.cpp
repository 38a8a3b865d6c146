#include "ljmd/io/formats/extended_xyz_writer.hpp"
#include "ljmd/io/formats/trajectory_writer.hpp"

namespace ljmd {

namespace {

void write_xyz_frame(OutputFile& file, const State& state, const TrajectoryOptions& options) {
    write_extended_xyz_frame(file, state, {.velocities = options.velocities}, options.si);
}

double xyz_bytes(Index atoms, Index frames, bool velocities) {
    constexpr double header = 200.0;
    constexpr double number = 20.0;
    constexpr double species_and_id = 8.0;
    const double vectors = velocities ? 3.0 : 1.0;  // position, velocity, momentum
    return static_cast<double>(frames) *
           (header + (species_and_id + 3.0 * vectors * number) * static_cast<double>(atoms));
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
