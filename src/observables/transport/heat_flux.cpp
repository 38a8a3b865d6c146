#include "ljmd/observables/transport/heat_flux.hpp"

#include <algorithm>
#include <array>

#include "ljmd/core/errors.hpp"
#include "ljmd/execution/loops.hpp"
#include "ljmd/model/velocities.hpp"
#include "ljmd/neighbors/linked_cells.hpp"
#include "ljmd/potentials/pair_term.hpp"

namespace ljmd {

namespace {

struct Neighbour {
    Index i;            ///< the atom that it is a neighbour of
    double dx, dy, dz;  ///< from the neighbour to the atom
    double r2;
};
constexpr std::size_t neighbours_at_once = 256;

}  // namespace

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
            const auto add = [&](const Neighbour& near) {
                const Vec3 r(near.dx, near.dy, near.dz);
                const PairTerm<double> term = pair_term(pair, near.r2);
                flux += 0.5 * (term.u * v.col(near.i) + term.w * r.dot(v.col(near.i)) * r);
            };
            // One candidate in seven is a neighbour. They are gathered first, without a branch to mispredict.
            std::array<Neighbour, neighbours_at_once> gathered;
            std::size_t count = 0;
            const auto add_gathered = [&] {
                std::for_each_n(gathered.begin(), count, add);
                count = 0;
            };
            cells.for_each_candidate(atoms, part, [&](const PairVisit& visit) {
                const double r2 = visit.dx * visit.dx + visit.dy * visit.dy + visit.dz * visit.dz;
                gathered[count] = {visit.i, visit.dx, visit.dy, visit.dz, r2};
                count += r2 < cutoff * cutoff ? 1 : 0;
                if (count == gathered.size()) {
                    add_gathered();
                }
            });
            add_gathered();
            return flux;
        };
        return join_blocks(atoms.execution(), cells.part_count(atoms), 1, Vec3(Vec3::Zero()), sum_of_part,
                           [](Vec3& total, const Vec3& part) { total += part; });
    });
    return sum / state.box().volume();
}

}  // namespace ljmd
