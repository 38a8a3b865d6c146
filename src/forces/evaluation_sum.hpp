#pragma once

#include <array>
#include <cstddef>

#include "execution/exact_sum.hpp"
#include "execution/loops.hpp"
#include "ljmd/detail/forces/force_field.hpp"

namespace ljmd {

/// Energy and virial of all parts of a sum over pairs, added without rounding (see ExactSum): the total depends on what
/// the parts are, not on their order.
class EvaluationSum {
  public:
    /// @param virial  of a part: xx, yy, zz, xy, xz, yz [epsilon]
    void add(double energy, const std::array<double, 6>& virial) {
        sums_[0].add(energy);
        for (std::size_t k = 0; k < virial.size(); ++k) {
            sums_[k + 1].add(virial[k]);
        }
    }

    /// With the parts of all ranks. Collective.
    [[nodiscard]] Evaluation value(Ranks& ranks) {
        add_other_ranks(ranks, sums_);
        std::array<double, 6> w{};
        for (std::size_t k = 0; k < w.size(); ++k) {
            w[k] = sums_[k + 1].value();
        }
        Evaluation total;
        total.potential_energy = sums_[0].value();
        total.virial << w[0], w[3], w[4], w[3], w[1], w[5], w[4], w[5], w[2];
        return total;
    }

  private:
    std::array<ExactSum, 7> sums_;  ///< energy, virial
};

}  // namespace ljmd
