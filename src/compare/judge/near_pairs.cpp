#include "ljmd/compare/judge/near_pairs.hpp"

#include <cmath>

namespace ljmd {

NearPairs::NearPairs(const std::vector<Vec3>& positions, const Vec3& edges, double range) : atoms_(positions.size()) {
    std::vector<Vec3> wrapped;
    wrapped.reserve(atoms_);
    for (const Vec3& r : positions) {
        wrapped.emplace_back(r.array() - edges.array() * (r.array() / edges.array()).floor());
    }
    for (std::size_t i = 0; i < atoms_; ++i) {
        for (std::size_t j = i + 1; j < atoms_; ++j) {
            const Vec3 direct = wrapped[i] - wrapped[j];
            const Vec3 images = (direct.array() / edges.array()).round();
            const Vec3 nearest = direct - images.cwiseProduct(edges);
            const double distance = nearest.norm();
            if (distance < range) {
                pairs_.push_back({i, j, nearest, distance, !images.isZero(0.0)});
            }
        }
    }
}

PairSums NearPairs::sums(const PairPotential& potential, const Assumed& assumed) const {
    PairSums result;
    result.forces.assign(atoms_, Vec3::Zero());
    for (const Pair& pair : pairs_) {
        if (pair.through_wall && !assumed.images) {
            continue;
        }
        const PairTerm<double> term = potential(pair.distance / assumed.sigma);
        const double w = assumed.epsilon * term.w / (assumed.sigma * assumed.sigma);  // -u'(r)/r
        const Vec3 force = w * pair.separation;
        result.potential_energy += assumed.epsilon * term.u;
        result.virial += w * pair.distance * pair.distance;
        result.forces[pair.i] += force;
        result.forces[pair.j] -= force;
    }
    return result;
}

PairPotential with_cutoff(const PairPotential& potential, double radius) {
    Cutoff cutoff = potential.cutoff();
    cutoff.radius = radius;
    return PairPotential::make(potential.formula(), potential.truncation(), cutoff, potential.parameters());
}

}  // namespace ljmd
