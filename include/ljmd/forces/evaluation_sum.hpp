#pragma once

#include <array>
#include <cstddef>

#include "ljmd/execution/exact_sum.hpp"
#include "ljmd/forces/force_field.hpp"

namespace ljmd {

/// Energy and virial of all parts of a sum over pairs, added without rounding (see ExactSum): the total depends on what
/// the parts are, not on their order.
class EvaluationSum {
  public:
    /// @param virial  of a part: xx, yy, zz, xy, xz, yz [epsilon]
    void add(double energy, const std::array<double, 6>& virial) {
        energy_.add(energy);
        for (std::size_t k = 0; k < virial.size(); ++k) {
            virial_[k].add(virial[k]);
        }
    }

    [[nodiscard]] Evaluation value() const {
        std::array<double, 6> w{};
        for (std::size_t k = 0; k < w.size(); ++k) {
            w[k] = virial_[k].value();
        }
        Evaluation total;
        total.potential_energy = energy_.value();
        total.virial << w[0], w[3], w[4], w[3], w[1], w[5], w[4], w[5], w[2];
        return total;
    }

  private:
    ExactSum energy_;
    std::array<ExactSum, 6> virial_;
};

}  // namespace ljmd
