#pragma once

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
class NearPairs {
  public:
    struct Pair {
        std::size_t i;
        std::size_t j;
        Vec3 separation;  ///< r_i - r_j of the nearest image [sigma]
        double distance;
        bool through_wall;  ///< the nearest image of j is not j in the box
    };

    /// All pairs closer than `range`, by their nearest images; O(N^2).
    /// @param positions  anywhere
    /// @pre range <= half the shortest edge
    NearPairs(const std::vector<Vec3>& positions, const Vec3& edges, double range);

    /// Assumptions of a sum.
    struct Assumed {
        double epsilon = 1.0;  ///< energy scale
        double sigma = 1.0;    ///< length scale: u'(r) = epsilon u(r/sigma)
        bool images = true;    ///< false: pairs through a wall are left out
    };

    /// U, W and forces of the pairs within the potential's cutoff, which sigma multiplies, too.
    [[nodiscard]] PairSums sums(const PairPotential& potential, const Assumed& assumed) const;
    [[nodiscard]] PairSums sums(const PairPotential& potential) const { return sums(potential, Assumed{}); }

    [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
    [[nodiscard]] std::size_t atoms() const { return atoms_; }

  private:
    std::size_t atoms_;
    std::vector<Pair> pairs_;
};

/// The same potential with another cutoff, in units of the potential's sigma. A switch begins where it did.
[[nodiscard]] PairPotential with_cutoff(const PairPotential& potential, double radius);

}  // namespace ljmd
