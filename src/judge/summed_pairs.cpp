#include "judge/summed_pairs.hpp"

#include <cmath>

namespace ljmd {

namespace {

/// Whether a sum sees a pair, from its atom i (side 1) or from its atom j (side -1).
bool sees(const SummedPairs::MissedImages& missed, const Vec3& images, double side) {
    for (std::size_t k = 0; k < missed.size(); ++k) {
        const double image = side * images[static_cast<Index>(k)];
        if ((image < 0.0 && missed[k][0]) || (image > 0.0 && missed[k][1])) {
            return false;
        }
    }
    return true;
}

}  // namespace

SummedPairs::SummedPairs(const std::vector<Vec3>& positions, const Vec3& edges, double range)
    : atoms_(positions.size()) {
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
                pairs_.push_back({i, j, nearest, distance, images});
            }
        }
    }
}

PairSums SummedPairs::sums(const PairPotential& potential, const Assumed& assumed) const {
    PairSums result;
    result.forces.assign(atoms_, Vec3::Zero());
    for (const Pair& pair : pairs_) {
        const double from_i = sees(assumed.missed, pair.images, 1.0) ? 1.0 : 0.0;
        const double from_j = assumed.each_atom_alone ? (sees(assumed.missed, pair.images, -1.0) ? 1.0 : 0.0) : from_i;
        const double both = 0.5 * (from_i + from_j);
        if (both == 0.0) {
            continue;
        }
        const PairTerm<double> term = potential(pair.distance / assumed.sigma);
        const double w = assumed.epsilon * term.w / (assumed.sigma * assumed.sigma);  // -u'(r)/r
        const Vec3 force = w * pair.separation;
        result.potential_energy += both * assumed.epsilon * term.u;
        result.virial += both * w * pair.distance * pair.distance;
        result.forces[pair.i] += from_i * force;
        result.forces[pair.j] -= from_j * force;
    }
    return result;
}

PairSums SummedPairs::sums_of(const std::function<PairTerm<double>(const Pair&)>& term) const {
    PairSums result;
    result.forces.assign(atoms_, Vec3::Zero());
    for (const Pair& pair : pairs_) {
        const auto [u, w] = term(pair);
        result.potential_energy += u;
        result.virial += w * pair.distance * pair.distance;
        result.forces[pair.i] += w * pair.separation;
        result.forces[pair.j] -= w * pair.separation;
    }
    return result;
}

SummedPairs SummedPairs::with_longer_edges(const Vec3& by) const {
    SummedPairs changed = *this;
    for (Pair& pair : changed.pairs_) {
        pair.separation -= pair.images.cwiseProduct(by);
        pair.distance = pair.separation.norm();
    }
    return changed;
}

PairPotential with_cutoff(const PairPotential& potential, double radius) {
    Cutoff cutoff = potential.cutoff();
    cutoff.radius = radius;
    return PairPotential::make(potential.formula(), potential.truncation(), cutoff, potential.parameters());
}

}  // namespace ljmd
