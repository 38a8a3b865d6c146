#include "trajectory_promises.hpp"

using namespace ljmd;

LJMD_FUZZ_TARGET(lammps_dump) {
    fuzz::check_trajectory(fuzz::file_of(data, size), std::nullopt);
    return 0;
}
