#include "ljmd/forces/atom_energies.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/execution/loops.hpp"
#include "ljmd/neighbors/linked_cells.hpp"

namespace ljmd {

namespace {

/// The atoms alone, in the order of their ids, so that the order in memory decides nothing.
State in_order_of_ids(const State& state) {
    State sorted(state.count(), state.box(), state.execution());
    auto r = sorted.write_positions();
    const std::vector<Index> index_of = state.index_of();
    for (Index id = 0; id < state.count(); ++id) {
        r.col(id) = state.positions().col(index_of[static_cast<std::size_t>(id)]);
    }
    sorted.wrap();
    return sorted;
}

}  // namespace

std::vector<double> atom_energies(const State& state, const PairPotential& potential) {
    const double cutoff = potential.cutoff().radius;
    if (cutoff > 0.5 * state.box().shortest_edge()) {
        throw ContractViolation("the cutoff exceeds half the shortest edge of the box");
    }
    State atoms = in_order_of_ids(state);
    LinkedCells search;
    search.prepare(atoms, cutoff);
    const double cutoff2 = cutoff * cutoff;
    std::vector<double> energies(static_cast<std::size_t>(atoms.count()));
    potential.visit([&](const auto& pair) {
        for_each_block(atoms.execution(), search.part_count(atoms), 1, [&](Index part, Index) {
            search.for_each_candidate(atoms, part, [&](const PairVisit& visit) {
                const double r2 = visit.dx * visit.dx + visit.dy * visit.dy + visit.dz * visit.dz;
                if (r2 < cutoff2) {
                    energies[static_cast<std::size_t>(atoms.ids()[static_cast<std::size_t>(visit.i)])] +=
                        0.5 * pair(distance_from(r2)).u;
                }
            });
        });
    });
    return energies;
}

}  // namespace ljmd
