#pragma once

#include <algorithm>
#include <array>

#include "ljmd/detail/model/state.hpp"
#include "neighbors/linked_cells.hpp"

namespace ljmd {

/// A neighbour within the cutoff, as an atom meets it.
struct Neighbor {
    Index i;            ///< the atom, an index of PairsWithin::atoms()
    Index j;            ///< its neighbour; at least atoms().count() for the image of an atom
    double dx, dy, dz;  ///< r_i - r_j [sigma]
    double r2;          ///< squared distance [sigma^2], below the squared cutoff
};

/// All pairs of a configuration within a cutoff, for sums that the force kernels do not compute. Works on a copy of the
/// positions, sorted into linked cells, so the state is not changed. The copy is made in the order of the ids: neither
/// the order of atoms in memory nor the number of threads changes a bit of a sum that is joined part by part.
class PairsWithin {
  public:
    /// @param cutoff  [sigma], > 0, at most half the shortest edge of the state's box (checked: ContractViolation)
    PairsWithin(const State& state, double cutoff);

    /// The copy: positions, ids and box, without velocities and forces.
    [[nodiscard]] const State& atoms() const { return atoms_; }

    /// Parts into which the atoms are split, for threads to share.
    [[nodiscard]] Index part_count() const { return cells_.part_count(atoms_); }
    [[nodiscard]] AtomRange atoms_of(Index part) const { return cells_.atoms_of(atoms_, part); }

    /// visit(const Neighbor&) for every neighbour of every atom of a part: each pair is met from both sides.
    template <class Visit>
    void for_each(Index part, const Visit& visit) const {
        // One candidate in seven is a neighbour. They are gathered first, without a branch to mispredict.
        std::array<Neighbor, 256> gathered;
        std::size_t count = 0;
        const auto visit_gathered = [&] {
            std::for_each_n(gathered.begin(), count, visit);
            count = 0;
        };
        cells_.for_each_candidate(atoms_, part, [&](const PairVisit& pair) {
            const double r2 = pair.dx * pair.dx + pair.dy * pair.dy + pair.dz * pair.dz;
            gathered[count] = {pair.i, pair.j, pair.dx, pair.dy, pair.dz, r2};
            count += r2 < cutoff2_ ? 1 : 0;
            if (count == gathered.size()) {
                visit_gathered();
            }
        });
        visit_gathered();
    }

  private:
    State atoms_;
    LinkedCells cells_;
    double cutoff2_;
};

}  // namespace ljmd
