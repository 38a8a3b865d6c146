#include "configuration_promises.hpp"
#include "io/formats/nist_format.hpp"

using namespace ljmd;

LJMD_FUZZ_TARGET(nist) {
    try {
        TextFile file(fuzz::file_of(data, size));
        fuzz::check_promises(read_nist(file));
    } catch (const DataError&) {
    }
    return 0;
}
