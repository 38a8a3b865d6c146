#include "configuration_promises.hpp"
#include "io/formats/lammps_data_reader.hpp"

using namespace ljmd;

LJMD_FUZZ_TARGET(lammps_data) {
    try {
        TextFile file(fuzz::file_of(data, size));
        fuzz::check_promises(read_lammps_data(file));
    } catch (const DataError&) {
    }
    return 0;
}
