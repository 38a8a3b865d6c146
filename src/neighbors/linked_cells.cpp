#include "ljmd/neighbors/linked_cells.hpp"

#include "ljmd/core/stopwatch.hpp"

namespace ljmd {

void LinkedCells::prepare(State& state, double cutoff) {
    Stopwatch watch;
    state.wrap();
    grid_.configure(state.box(), cutoff, state.count());
    state.reorder(grid_.spatial_order(state));
    ghosts_.create(state, cutoff);
    grid_.fill(state.positions_and_ghosts());
    statistics_.seconds_sorting += watch.lap();
    ++statistics_.preparations;
    ++statistics_.rebuilds;
}

}  // namespace ljmd
