#include "ljmd/core/errors.hpp"
#include "sweep_promises.hpp"

using namespace ljmd;

LJMD_FUZZ_TARGET(sweep_list) {
    try {
        Diagnostics diagnostics;
        fuzz::check_promises(list_points(fuzz::file_of(data, size), {"system.seed=3"}, diagnostics), diagnostics);
    } catch (const DataError&) {
    }
    return 0;
}
