#pragma once

#include <algorithm>
#include <array>
#include <type_traits>

#include "ljmd/core/threads.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/forces/force_sum.hpp"

namespace ljmd {

/// Sum one pair term over all neighbours of all atoms: the readable reference that faster paths are held against.
///
/// @param pair    PairTerm<double> operator()(double r2) const, valid for r < cutoff
/// @param search  prepared pair search (see PairSearch)
/// @post state.forces() hold the forces; a pair counts if r < cutoff
/// @tparam what   order_independent: forces are summed in fixed point (see FixedPointSum)
template <Request what, class Pair, class Search>
Evaluation sum_pairs(const Pair& pair, const Search& search, double cutoff, State& state) {
    using Sum = std::conditional_t<what.order_independent, FixedPointSum, FloatingSum>;
    constexpr Index block_length = 256;
    const double cutoff2 = cutoff * cutoff;
    auto forces = state.write_forces();
    const State& atoms = state;

    const auto sum_block = [&](Index first, Index last) {
        double u = 0.0;
        std::array<double, 6> virial{};  // xx yy zz xy xz yz
        for (Index i = first; i < last; ++i) {
            Sum fx;
            Sum fy;
            Sum fz;
            search.for_each_candidate(atoms, i, [&](Index, double dx, double dy, double dz) {
                const double r2 = dx * dx + dy * dy + dz * dz;
                if (!(r2 < cutoff2)) {
                    return;
                }
                const auto term = pair(r2);
                fx.add(term.w * dx);
                fy.add(term.w * dy);
                fz.add(term.w * dz);
                if constexpr (what.energy) {
                    u += term.u;
                    virial[0] += term.w * dx * dx;
                    virial[1] += term.w * dy * dy;
                    virial[2] += term.w * dz * dz;
                    virial[3] += term.w * dx * dy;
                    virial[4] += term.w * dx * dz;
                    virial[5] += term.w * dy * dz;
                }
            });
            forces.col(i) << fx.value(), fy.value(), fz.value();
        }
        Evaluation block;
        if constexpr (what.energy) {
            block.potential_energy = 0.5 * u;  // every pair was seen from both sides
            block.virial << virial[0], virial[3], virial[4], virial[3], virial[1], virial[5], virial[4], virial[5],
                virial[2];
            block.virial *= 0.5;
        }
        return block;
    };
    return join_blocks(state.count(), block_length, Evaluation{}, sum_block,
                       [](Evaluation& sum, const Evaluation& block) {
                           sum.potential_energy += block.potential_energy;
                           sum.virial += block.virial;
                       });
}

}  // namespace ljmd
