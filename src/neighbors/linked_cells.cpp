#include "neighbors/linked_cells.hpp"

#include "core/stopwatch.hpp"

namespace ljmd {

void LinkedCells::prepare(State& state, double cutoff) {
    Stopwatch watch;
    grid_.configure(state.box(), cutoff, state.count());
    grid_.sort(state, ghosts_);
    statistics_.seconds_sorting += watch.lap();
    ++statistics_.preparations;
    ++statistics_.rebuilds;
}

}  // namespace ljmd
