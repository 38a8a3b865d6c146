#include "trajectory_promises.hpp"

using namespace ljmd;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::check_trajectory(fuzz::file_of(data, size), std::nullopt);
    return 0;
}
