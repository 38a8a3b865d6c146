#include "compare/lammps_output.hpp"
#include "fuzz_target.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

// What LAMMPS prints: its log, and its help, which tells its version.
LJMD_FUZZ_TARGET(lammps_log) {
    static_cast<void>(lammps_version(std::string(fuzz::text_of(data, size))));
    try {
        LammpsLog log(fuzz::file_of(data, size));
        while (log.next_row()) {
        }
        static_cast<void>(log.loop_seconds());
        ++fuzz::inputs_accepted;
    } catch (const DataError&) {
    }
    return 0;
}
