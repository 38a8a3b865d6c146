#pragma once

#include <array>
#include <functional>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Sums over pairs of one configuration, without tail corrections.
struct PairSums {
    double potential_energy = 0.0;  ///< U [epsilon]
    double virial = 0.0;            ///< W = sum of r . f [epsilon]
    std::vector<Vec3> forces;       ///< on each atom [epsilon/sigma]
};

/// The pairs of a configuration up to some distance, to be summed again and again under other assumptions: this is how
/// ljmd finds out by which mistake the numbers of another engine come about.
class SummedPairs {
  public:
    struct Pair {
        std::size_t i;
        std::size_t j;
        Vec3 separation;  ///< r_i - r_j of the nearest image [sigma]
        double distance;
        Vec3 images;  ///< edges that the nearest image of j is away from j in the box: -1, 0 or 1 in each direction
    };

    /// The images that a sum leaves out: missed[k][0] for pairs with r_i - r_j < -L/2 in direction k, missed[k][1] for
    /// pairs with r_i - r_j > L/2. Such a pair is farther apart in the box than half an edge, and so not seen at all.
    using MissedImages = std::array<std::array<bool, 2>, 3>;

    /// All pairs closer than `range`, by their nearest images; O(N^2).
    /// @param positions  anywhere
    /// Beyond half the shortest edge other images are missing, as with programs that know the nearest one alone.
    SummedPairs(const std::vector<Vec3>& positions, const Vec3& edges, double range);

    /// Assumptions of a sum.
    struct Assumed {
        double epsilon = 1.0;  ///< energy scale
        double sigma = 1.0;    ///< length scale: u'(r) = epsilon u(r/sigma)
        MissedImages missed{};
        bool each_atom_alone = false;  ///< each atom sums over all others, and misses images as atom i of the pair
    };

    /// U, W and forces of the pairs within the potential's cutoff, which sigma multiplies, too.
    [[nodiscard]] PairSums sums(const PairPotential& potential, const Assumed& assumed) const;
    [[nodiscard]] PairSums sums(const PairPotential& potential) const { return sums(potential, Assumed{}); }

    /// The same of any terms of pairs.
    [[nodiscard]] PairSums sums_of(const std::function<PairTerm<double>(const Pair&)>& term) const;

    /// The pairs as they are in a box whose edges are longer by this, with the atoms where they are.
    [[nodiscard]] SummedPairs with_longer_edges(const Vec3& by) const;

    [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
    [[nodiscard]] std::size_t atoms() const { return atoms_; }

  private:
    std::size_t atoms_;
    std::vector<Pair> pairs_;
};

/// The same potential with another cutoff, in units of the potential's sigma. A switch begins where it did.
[[nodiscard]] PairPotential with_cutoff(const PairPotential& potential, double radius);

}  // namespace ljmd
