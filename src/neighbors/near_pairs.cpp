#include "ljmd/detail/neighbors/near_pairs.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "execution/loops.hpp"
#include "neighbors/pairs_within.hpp"

namespace ljmd {

namespace {

/// What the atoms of one part meet, each pair from both sides.
struct Met {
    Index count = 0;
    double nearest2 = std::numeric_limits<double>::infinity();
    Index atom = 0;  ///< an index of PairsWithin::atoms()
};

/// The atom that has an image nearest to another one.
Index nearest_to(const State& atoms, Index atom) {
    Index found = atom;
    double nearest2 = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < atoms.count(); ++i) {
        const Vec3 separation = atoms.positions().col(i) - atoms.positions().col(atom);
        const double r2 = atoms.box().minimum_image(separation).squaredNorm();
        if (i != atom && r2 < nearest2) {
            nearest2 = r2;
            found = i;
        }
    }
    return found;
}

}  // namespace

NearPairs pairs_nearer_than(const State& state, double distance) {
    const PairsWithin pairs(state, distance);
    std::vector<Met> parts(static_cast<std::size_t>(pairs.part_count()));
    for_each_block(state.execution(), pairs.part_count(), 1, [&](Index part, Index) {
        Met& met = parts[static_cast<std::size_t>(part)];
        pairs.for_each(part, [&](const Neighbor& near) {
            ++met.count;
            if (near.r2 < met.nearest2) {
                met.nearest2 = near.r2;
                met.atom = near.i;
            }
        });
    });
    Met all;
    for (const Met& part : parts) {
        all.count += part.count;
        if (part.nearest2 < all.nearest2) {
            all.nearest2 = part.nearest2;
            all.atom = part.atom;
        }
    }
    if (all.count == 0) {
        return {};
    }
    const std::vector<Index>& ids = pairs.atoms().ids();
    return {all.count / 2, std::sqrt(all.nearest2), ids[static_cast<std::size_t>(all.atom)],
            ids[static_cast<std::size_t>(nearest_to(pairs.atoms(), all.atom))]};
}

}  // namespace ljmd
