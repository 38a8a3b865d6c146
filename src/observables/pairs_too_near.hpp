#pragma once

#include <string>
#include <utility>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/neighbors/near_pairs.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Pairs of a configuration that are nearer than the first distance of their potential's table (PairTable). There the
/// force is constant, which is nobody's formula: a fluid whose pairs get there is softer than the one that was meant.
/// @return none where the potential has no table, or one from 0
[[nodiscard]] NearPairs pairs_too_near(const State& state, const PairPotential& potential);

/// A sentence about such pairs of one configuration; empty if there are none.
[[nodiscard]] std::string too_near_in_words(const NearPairs& too_near, const PairPotential& potential);

/// Counts such pairs in the samples of a run. What happens between two samples is not seen, but what changes the
/// averages by more than their errors is.
class PairsTooNear {
  public:
    explicit PairsTooNear(PairPotential potential) : potential_(std::move(potential)) {}

    /// Add a configuration. Collective.
    void sample(const State& state);

    /// Why averages over the samples are in doubt; empty if no pair was too near.
    [[nodiscard]] std::string remark() const;

    /// Nothing is archived of a potential without such a table.
    void archive(Archive& a);

  private:
    PairPotential potential_;
    Index samples_ = 0;
    Index samples_with_ = 0;  ///< in which there was such a pair
    Index pairs_ = 0;         ///< of all samples together
    double nearest_ = 0.0;    ///< distance of the nearest pair [sigma]
};

}  // namespace ljmd
