#include "observables/transport/heat_flux.hpp"

#include "execution/loops.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"
#include "neighbors/pairs_within.hpp"
#include "observables/transport/centre_frame.hpp"

namespace ljmd {

namespace {

/// Velocities about the centre of mass, in the order of other atoms with the same ids.
Eigen::Matrix3Xd peculiar_velocities(const State& state, const std::vector<Index>& ids) {
    const Eigen::Matrix3Xd by_id = velocities_about_centre(state);
    Eigen::Matrix3Xd v(3, state.count());
    for (Index i = 0; i < state.count(); ++i) {
        v.col(i) = by_id.col(ids[static_cast<std::size_t>(i)]);
    }
    return v;
}

}  // namespace

Vec3 heat_flux(const State& state, const PairPotential& potential) {
    const PairsWithin pairs(state, potential.cutoff().radius);
    const Eigen::Matrix3Xd v = peculiar_velocities(state, pairs.atoms().ids());
    const Vec3 sum = potential.visit([&](const auto& pair) {
        const auto sum_of_part = [&](Index part, Index) {
            Vec3 flux = Vec3::Zero();
            const AtomRange range = pairs.atoms_of(part);
            for (Index i = range.first; i < range.last; ++i) {
                flux += 0.5 * v.col(i).squaredNorm() * v.col(i);
            }
            // Each side of a pair takes the terms with the velocity of its atom.
            pairs.for_each(part, [&](const Neighbor& near) {
                const Vec3 r(near.dx, near.dy, near.dz);
                const PairTerm<double> term = pair_term(pair, near.r2);
                flux += 0.5 * (term.u * v.col(near.i) + term.w * r.dot(v.col(near.i)) * r);
            });
            return flux;
        };
        return join_blocks(state.execution(), pairs.part_count(), 1, Vec3(Vec3::Zero()), sum_of_part,
                           [](Vec3& total, const Vec3& part) { total += part; });
    });
    return sum / state.box().volume();
}

}  // namespace ljmd
