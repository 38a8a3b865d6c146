#include "fuzz_target.hpp"
#include "ljmd/compare/lammps_output.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

// All frames, until the file ends or something in it is wrong.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr Index atoms = 2;
    try {
        LammpsDump dump(fuzz::file_of(data, size), atoms, "id xu yu zu");
        for (;;) {
            dump.next_frame();
            fuzz::require(std::ssize(dump.vectors()) == atoms, "a frame has another number of atoms");
            ++fuzz::inputs_accepted;
        }
    } catch (const DataError&) {
    }
    return 0;
}
