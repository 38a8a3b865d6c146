#pragma once

#include <vector>

#include "judge/summed_pairs.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// Forces that are wrong, as far as pairs within the cutoff that were left out explain them.
class MissingPairs {
  public:
    /// @param right  ljmd's forces at these positions  @param noise  length of a difference that is none
    MissingPairs(const std::vector<Vec3>& positions, const std::vector<Vec3>& found, const std::vector<Vec3>& right,
                 const Vec3& edges, const PairPotential& potential, double noise);

    [[nodiscard]] Index wrong_atoms() const;

    /// The missing pairs if those are missing that were farthest apart at earlier positions, beyond the cutoff, and
    /// hardly another pair was so far: as those that a list of that time lacks. None if that explains nothing.
    [[nodiscard]] std::vector<SummedPairs::Pair> farthest_in(const std::vector<Vec3>& earlier, const Vec3& edges) const;

    /// The missing pairs if every pair of wrong atoms is there or missing: least squares for the part of each pair that
    /// is missing. None if parts are not 0 or 1, or if there are too many pairs to tell.
    [[nodiscard]] std::vector<SummedPairs::Pair> of_any() const;

  private:
    void take_off(std::vector<Vec3>& rest, std::size_t k) const;

    double cutoff_;
    SummedPairs pairs_;
    std::vector<Vec3> lacking_;  ///< F - F' of each atom
    std::vector<bool> wrong_;
    std::vector<SummedPairs::Pair> candidates_;  ///< between wrong atoms
    std::vector<Vec3> forces_;                   ///< of the candidates
};

}  // namespace ljmd
