#include "ljmd/observables/transport/heat_flux.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/execution/loops.hpp"
#include "ljmd/model/velocities.hpp"
#include "ljmd/neighbors/linked_cells.hpp"
#include "ljmd/potentials/pair_term.hpp"

namespace ljmd {

Vec3 heat_flux(const State& state, const PairPotential& potential) {
    const double cutoff = potential.cutoff().radius;
    if (cutoff > 0.5 * state.box().shortest_edge()) {
        throw ContractViolation("the heat flux needs a cutoff of at most half the box");
    }
    // The cells sort and wrap atoms, so they work on a copy of the state.
    State copy(state.count(), state.box(), state.execution());
    copy.write_positions() = state.positions();
    copy.write_velocities() = state.velocities().colwise() - centre_velocity(state);
    LinkedCells cells;
    cells.prepare(copy, cutoff);
    const State& atoms = copy;
    const auto v = atoms.velocities();
    const Vec3 sum = potential.visit([&](const auto& pair) {
        const auto sum_of_part = [&](Index part, Index) {
            Vec3 flux = Vec3::Zero();
            const AtomRange range = cells.atoms_of(atoms, part);
            for (Index i = range.first; i < range.last; ++i) {
                flux += 0.5 * v.col(i).squaredNorm() * v.col(i);
            }
            // Each pair is visited from both sides, and each side takes the terms with the velocity of its atom.
            cells.for_each_candidate(atoms, part, [&](const PairVisit& visit) {
                const Vec3 r(visit.dx, visit.dy, visit.dz);
                const double r2 = r.squaredNorm();
                if (r2 < cutoff * cutoff) {
                    const PairTerm<double> term = pair_term(pair, r2);
                    flux += 0.5 * (term.u * v.col(visit.i) + term.w * r.dot(v.col(visit.i)) * r);
                }
            });
            return flux;
        };
        return join_blocks(atoms.execution(), cells.part_count(atoms), 1, Vec3(Vec3::Zero()), sum_of_part,
                           [](Vec3& total, const Vec3& part) { total += part; });
    });
    return sum / state.box().volume();
}

}  // namespace ljmd
