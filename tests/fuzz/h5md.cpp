#include <span>

#include "io/formats/trajectory_writer.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "trajectory_promises.hpp"
#include "two_atoms.hpp"

using namespace ljmd;

// What begins as an HDF5 file is read as one. Anything else is a trajectory that is continued: what a checkpoint knows
// of it, and behind that the file.
LJMD_FUZZ_TARGET(h5md) {
    static const State state = fuzz::two_atoms();
    if (fuzz::text_of(data, size).starts_with("\x89HDF\r\n\x1a\n")) {
        fuzz::check_trajectory(fuzz::file_of(data, size), std::nullopt);
        return 0;
    }
    try {
        Archive places(std::as_bytes(std::span(data, size)));
        CommittedFrames frames;
        places(frames);
        Archive again;
        again(frames);
        const std::size_t length = again.bytes().size();
        const auto& path = fuzz::file_of(data + length, size - length);
        make_trajectory_writer("h5md", state, {.path = path, .velocities = true, .kept = frames})->close();
        ++fuzz::inputs_accepted;
    } catch (const CheckpointError&) {
    }
    return 0;
}
