#pragma once

#include "ljmd/forces/force_field.hpp"
#include "ljmd/neighbors/pair_search.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// Pair forces in a periodic box: f_i = sum over j with r_ij < rc of w(r_ij) (r_i - r_j).
///
/// Each atom's force is a sum from its own side over full neighbourhoods; energy and virial are half the sum over
/// atoms, added up in blocks of fixed length. Neither depends on more than the configuration and the order it decides.
class PairForceField : public ForceField {
  public:
    /// @pre potential.cutoff().radius <= L/2 for every box that will be evaluated (checked: ContractViolation)
    PairForceField(PairPotential potential, PairSearch search)
        : potential_(std::move(potential)), search_(std::move(search)) {}

    [[nodiscard]] const PairPotential& potential() const { return potential_; }
    [[nodiscard]] const PairSearch& search() const { return search_; }
    [[nodiscard]] const SearchStatistics& search_statistics() const;

  private:
    Evaluation compute(State& state, Request request) override;

    PairPotential potential_;
    PairSearch search_;
};

}  // namespace ljmd
