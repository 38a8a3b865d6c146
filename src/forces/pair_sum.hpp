#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "execution/loops.hpp"
#include "forces/evaluation_sum.hpp"
#include "forces/force_sum.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"
#include "neighbors/halo.hpp"
#include "neighbors/pair_visit.hpp"
#include "neighbors/verlet_list.hpp"

namespace ljmd {

/// Sum a pair term over all neighbours of all atoms: the readable reference that the kernels are tested against.
///
/// @param pair    PairTerm<double> operator()(const PairDistance<double>&) const, valid for r < cutoff
/// @param search  prepared pair search (see PairSearch)
/// @post state.forces() holds the forces; a pair counts if r < cutoff
/// @tparam what   with order_independent, forces are summed in fixed point (see FixedPointSum)
template <Request what, class Pair, class Search>
Evaluation sum_pairs(const Pair& pair, const Search& search, double cutoff, State& state) {
    using Sum = std::conditional_t<what.order_independent, FixedPointSum, FloatingSum>;
    const double cutoff2 = cutoff * cutoff;
    auto forces = state.write_forces();
    const State& atoms = state;
    std::vector<std::array<Sum, 3>> sums(static_cast<std::size_t>(atoms.count()));
    const auto add = [&sums](Index atom, const std::array<double, 3>& force) {
        auto& sum = sums[static_cast<std::size_t>(atom)];
        for (std::size_t a = 0; a < 3; ++a) {
            sum[a].add(force[a]);
        }
    };
    struct PartSums {
        double energy = 0.0;
        std::array<double, 6> virial{};  // xx yy zz xy xz yz
    };
    std::vector<PartSums> of_parts(what.energy ? static_cast<std::size_t>(search.part_count(atoms)) : 0);
    // Reaction forces of each part on atoms of other parts, kept apart because another thread may be writing to these.
    std::vector<std::vector<Halo::OnAtom>> on_others(static_cast<std::size_t>(search.part_count(atoms)));

    const auto sum_part = [&](Index part, Index) {
        const AtomRange range = search.atoms_of(atoms, part);
        PartSums halves[2];  // by PairVisit::upper, so that the order of a sum does not depend on the shape of rows
        search.for_each_candidate(atoms, part, [&](const PairVisit& visit) {
            const auto& [i, j, dx, dy, dz, once, upper] = visit;
            const double r2 = dx * dx + dy * dy + dz * dz;
            if (!(r2 < cutoff2)) {
                return;
            }
            const auto term = pair(distance_from(r2));
            add(i, {term.w * dx, term.w * dy, term.w * dz});
            if (once) {
                const std::array reaction{-term.w * dx, -term.w * dy, -term.w * dz};
                if (range.first <= j && j < range.last) {
                    add(j, reaction);
                } else {
                    on_others[static_cast<std::size_t>(part)].push_back({j, reaction});
                }
            }
            if constexpr (what.energy) {
                const double sides = once ? 2.0 : 1.0;
                const double w = sides * term.w;
                auto& [u, virial] = halves[upper ? 1 : 0];
                u += sides * term.u;
                virial[0] += w * dx * dx;
                virial[1] += w * dy * dy;
                virial[2] += w * dz * dz;
                virial[3] += w * dx * dy;
                virial[4] += w * dx * dz;
                virial[5] += w * dy * dz;
            }
        });
        if constexpr (what.energy) {
            PartSums& sums_of_part = of_parts[static_cast<std::size_t>(part)];
            sums_of_part.energy = 0.5 * (halves[0].energy + halves[1].energy);  // each pair was counted from both sides
            for (std::size_t k = 0; k < sums_of_part.virial.size(); ++k) {
                sums_of_part.virial[k] = 0.5 * (halves[0].virial[k] + halves[1].virial[k]);
            }
        }
    };
    for_each_block(atoms.execution(), search.part_count(atoms), 1, sum_part);
    EvaluationSum total;
    for (const PartSums& part : of_parts) {
        total.add(part.energy, part.virial);
    }
    const auto add_all = [&add](const std::vector<Halo::OnAtom>& all) {
        for (const Halo::OnAtom& other : all) {
            add(other.atom, other.force);
        }
    };
    Ranks& ranks = atoms.execution().ranks();
    if constexpr (std::is_same_v<Search, VerletList>) {
        if (!ranks.alone()) {
            // In the order of the parts of all ranks, as one process would add them.
            std::vector<Halo::OnAtom> on_ghosts;
            for (std::vector<Halo::OnAtom>& of_part : on_others) {
                const auto ghosts =
                    std::stable_partition(of_part.begin(), of_part.end(),
                                          [&](const Halo::OnAtom& other) { return other.atom < atoms.count(); });
                for (auto ghost = ghosts; ghost != of_part.end(); ++ghost) {
                    on_ghosts.push_back({ghost->atom - atoms.count(), ghost->force});
                }
                of_part.erase(ghosts, of_part.end());
            }
            const auto from_ranks = search.clusters().halo().return_forces(ranks, on_ghosts);
            for (std::size_t rank = 0; rank < from_ranks.size(); ++rank) {
                if (static_cast<int>(rank) == ranks.rank()) {
                    std::ranges::for_each(on_others, add_all);
                } else {
                    add_all(from_ranks[rank]);
                }
            }
            on_others.clear();
        }
    }
    std::ranges::for_each(on_others, add_all);
    fail_together(ranks, [&] {
        for_each_index(atoms.execution(), atoms.count(), [&](Index i) {
            const auto& sum = sums[static_cast<std::size_t>(i)];
            forces.col(i) << sum[0].value(), sum[1].value(), sum[2].value();
        });
    });
    return total.value(ranks);
}

}  // namespace ljmd
