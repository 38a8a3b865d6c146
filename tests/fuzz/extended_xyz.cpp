#include "io/formats/configuration_reader.hpp"
#include "trajectory_promises.hpp"

using namespace ljmd;

// By the readers of all formats, so that the others are recognised here, too: as a start, and as a trajectory. With
// units, files in SI units are read.
LJMD_FUZZ_TARGET(extended_xyz) {
    constexpr double sigma = 3.405e-10;
    constexpr double epsilon = 1.654e-21;
    constexpr double mass = 6.6335e-26;
    const SubstanceUnits units(sigma, epsilon, mass);
    const auto& path = fuzz::file_of(data, size);
    try {
        fuzz::check_promises(read_configuration(path, units));
    } catch (const DataError&) {
    }
    try {
        fuzz::check_promises(read_configuration(path, units, "Lattice={6 0 0 0 6 0 0 0 6}"));
    } catch (const DataError&) {
    }
    fuzz::check_trajectory(path, units);
    return 0;
}
