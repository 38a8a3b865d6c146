#include "sweep_promises.hpp"

using namespace ljmd;

// The input is the argument of a --grid.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Diagnostics diagnostics;
    fuzz::check_promises(grid_points({std::string(fuzz::text_of(data, size))}, {"system.seed=3"}, diagnostics),
                         diagnostics);
    return 0;
}
