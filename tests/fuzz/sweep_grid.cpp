#include "sweep_promises.hpp"

using namespace ljmd;

// The input is the argument of a --grid.
LJMD_FUZZ_TARGET(sweep_grid) {
    Diagnostics diagnostics;
    fuzz::check_promises(grid_points({std::string(fuzz::text_of(data, size))}, {"system.seed=3"}, diagnostics),
                         diagnostics);
    return 0;
}
