#include "neighbors/pairs_within.hpp"

#include "ljmd/core/errors.hpp"

namespace ljmd {

PairsWithin::PairsWithin(const State& state, double cutoff)
    : atoms_(state.count(), state.box(), state.execution()), cutoff2_(cutoff * cutoff) {
    if (!(cutoff > 0.0 && cutoff <= 0.5 * state.box().shortest_edge())) {
        throw ContractViolation("pairs are found within a cutoff of at most half the shortest edge of the box");
    }
    auto r = atoms_.write_positions();
    const std::vector<Index> index_of = state.index_of();
    for (Index id = 0; id < state.count(); ++id) {
        r.col(id) = state.positions().col(index_of[static_cast<std::size_t>(id)]);
    }
    atoms_.wrap();
    cells_.prepare(atoms_, cutoff);
}

}  // namespace ljmd
