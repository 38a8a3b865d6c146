#include "observables/interface/pressure_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "execution/loops.hpp"
#include "model/velocities.hpp"
#include "neighbors/pairs_within.hpp"

namespace ljmd {

namespace {

/// Each block of parts has its own profiles: enough blocks for many threads, few enough for many layers.
constexpr Index max_blocks = 64;

/// Pairs that lie flatter than this, in layers, count in one of them.
constexpr double flat = 1e-9;

/// Virials of pairs by layer: normal in the first column, tangential in the second.
using Virials = Eigen::Array<double, Eigen::Dynamic, 2>;

/// Coordinates in layers: from 0 to `count`, periodic.
class Layers {
  public:
    Layers(double edge, double centre, Index count)
        : count_(count), first_(centre - 0.5 * edge), per_length_(static_cast<double>(count) / edge) {}

    [[nodiscard]] double coordinate(double z) const { return (z - first_) * per_length_; }
    [[nodiscard]] Index of(double coordinate) const {
        const auto layer = static_cast<Index>(std::floor(coordinate)) % count_;
        return layer < 0 ? layer + count_ : layer;
    }
    /// Spread values evenly over the coordinates between two.
    void spread(Virials& profile, double one, double other, const Eigen::Array<double, 1, 2>& values) const {
        const double begin = std::min(one, other);
        const double end = std::max(one, other);
        if (end - begin < flat) {
            profile.row(of(begin)) += values;
            return;
        }
        for (double layer = std::floor(begin); layer < end; layer += 1.0) {
            const double inside = std::min(end, layer + 1.0) - std::max(begin, layer);
            profile.row(of(layer)) += values * (inside / (end - begin));
        }
    }

  private:
    Index count_;
    double first_;
    double per_length_;
};

template <class Pair>
Virials pair_virials(const Pair& pair, const PairsWithin& pairs, Index axis, const Layers& layers, Index count) {
    const Index parts = pairs.part_count();
    const State& atoms = pairs.atoms();
    const auto of_block = [&](Index first, Index last) {
        Virials found = Virials::Zero(count, 2);
        for (Index part = first; part < last; ++part) {
            pairs.for_each(part, [&](const Neighbor& near) {
                const double dz = Vec3(near.dx, near.dy, near.dz)[axis];
                const double w = 0.5 * pair_term(pair, near.r2).w;  // from both sides
                const double z = atoms.positions()(axis, near.i);
                layers.spread(found, layers.coordinate(z), layers.coordinate(z - dz),
                              {w * dz * dz, 0.5 * w * (near.r2 - dz * dz)});
            });
        }
        return found;
    };
    return join_blocks(atoms.execution(), parts, std::max((parts + max_blocks - 1) / max_blocks, Index{1}),
                       Virials(Virials::Zero(count, 2)), of_block,
                       [](Virials& sum, const Virials& block) { sum += block; });
}

}  // namespace

double film_centre(const State& state, Index axis) {
    const double edge = state.box().edges()[axis];
    const double per_length = 2.0 * std::numbers::pi / edge;
    const auto sum = sum_over<Eigen::Vector2d>(state.execution(), state.count(), [&](Index i) {
        const double turn = per_length * state.positions()(axis, i);
        return Eigen::Vector2d(std::cos(turn), std::sin(turn));
    });
    return std::atan2(sum[1], sum[0]) / per_length;
}

PressureProfile pressure_profile(const State& state, const PairPotential& potential, Index axis, double centre,
                                 Index layers) {
    const PairsWithin pairs(state, potential.cutoff().radius);
    const Layers places(state.box().edges()[axis], centre, layers);
    const Virials virials =
        potential.visit([&](const auto& pair) { return pair_virials(pair, pairs, axis, places, layers); });

    PressureProfile profile{Eigen::VectorXd::Zero(layers), virials.col(0), virials.col(1)};
    const auto atoms = static_cast<double>(state.count());
    const double about_centre = atoms / (atoms - 1.0);
    const Vec3 drift = centre_velocity(state);
    for (Index i = 0; i < state.count(); ++i) {
        const Index layer = places.of(places.coordinate(state.positions()(axis, i)));
        const Vec3 v = state.velocities().col(i) - drift;
        const double mass = about_centre * state.masses()[static_cast<std::size_t>(i)];
        const double normal = v[axis] * v[axis];
        profile.density[layer] += 1.0;
        profile.normal[layer] += mass * normal;
        profile.tangential[layer] += 0.5 * mass * (v.squaredNorm() - normal);
    }
    const double layers_per_volume = static_cast<double>(layers) / state.box().volume();
    profile.density *= layers_per_volume;
    profile.normal *= layers_per_volume;
    profile.tangential *= layers_per_volume;
    return profile;
}

}  // namespace ljmd
