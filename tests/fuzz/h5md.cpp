#include <span>

#include "fuzz_target.hpp"
#include "ljmd/core/archive.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/trajectory_writer.hpp"
#include "two_atoms.hpp"

using namespace ljmd;

// A trajectory that is gone on with: where a checkpoint says that its frames lie, and behind that the file.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const State state = fuzz::two_atoms();
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
