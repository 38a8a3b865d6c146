#include "forces/atom_energies.hpp"

#include "execution/loops.hpp"
#include "neighbors/pairs_within.hpp"

namespace ljmd {

std::vector<double> atom_energies(const State& state, const PairPotential& potential) {
    const PairsWithin pairs(state, potential.cutoff().radius);
    const std::vector<Index>& ids = pairs.atoms().ids();
    std::vector<double> energies(ids.size());
    potential.visit([&](const auto& pair) {
        for_each_block(state.execution(), pairs.part_count(), 1, [&](Index part, Index) {
            pairs.for_each(part, [&](const Neighbor& near) {
                const Index id = ids[static_cast<std::size_t>(near.i)];
                energies[static_cast<std::size_t>(id)] += 0.5 * pair_term(pair, near.r2).u;
            });
        });
    });
    return energies;
}

}  // namespace ljmd
