#include "ljmd/io/formats/trajectory_writer.hpp"

#include <fmt/format.h>

#include "h5md_writer.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/formats/extended_xyz_writer.hpp"

namespace ljmd {

std::unique_ptr<TrajectoryWriter> make_trajectory_writer(const std::string& format, const State& first,
                                                         const TrajectoryOptions& options) {
    if (format == "h5md") {
        return std::make_unique<H5mdWriter>(first, options);
    }
    if (format == "xyz") {
        return std::make_unique<ExtendedXyzWriter>(first, options);
    }
    throw InputError(fmt::format("unknown trajectory format '{}': allowed are 'h5md' and 'xyz'", format));
}

double trajectory_bytes(const std::string& format, Index atoms, Index frames, bool velocities) {
    return format == "h5md" ? h5md_bytes(atoms, frames, velocities) : extended_xyz_bytes(atoms, frames, velocities);
}

}  // namespace ljmd
