#include "observables/pair_curvature.hpp"

#include <algorithm>
#include <cmath>

#include "execution/loops.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"
#include "neighbors/pairs_within.hpp"

namespace ljmd {

namespace {

constexpr double step = 1e-5;  // of ln r
constexpr double shell = 0.1;  // b [sigma]

/// The sums of one pair, for a potential of its own type.
template <class Pair>
class CurvatureOfPair {
  public:
    CurvatureOfPair(const Pair& pair, double cutoff)
        : pair_(pair),
          cutoff2_(cutoff * cutoff),
          shell_(std::min(shell, 0.5 * cutoff)),
          at_cutoff_(pair_term(pair, cutoff2_)),
          step_at_cutoff_(-cutoff2_ * cutoff * at_cutoff_.w) {}

    /// @pre 0 < r2 < cutoff^2
    [[nodiscard]] PairCurvature operator()(double r2) const {
        const PairTerm<double> here = pair_term(pair_, r2);
        const double slope = virial_slope(r2) + delta_at_cutoff(r2);
        return {here.u - at_cutoff_.u, -slope, -2.0 * (slope + here.w * r2) / r2};
    }

  private:
    [[nodiscard]] double virial(double r2) const { return pair_term(pair_, r2).w * r2; }

    /// r y' within the cutoff.
    [[nodiscard]] double virial_slope(double r2) const {
        const double below = r2 * std::exp(-2.0 * step);
        const double above = r2 * std::exp(2.0 * step);
        if (above < cutoff2_) {
            return (virial(above) - virial(below)) / (2.0 * step);
        }
        return (virial(cutoff2_) - virial(below)) / (0.5 * std::log(cutoff2_ / below));
    }

    /// -rc y(rc) delta(r - rc), spread over the shell.
    [[nodiscard]] double delta_at_cutoff(double r2) const {
        if (step_at_cutoff_ == 0.0) {
            return 0.0;
        }
        const double s = std::sqrt(cutoff2_) - std::sqrt(r2);
        return s < shell_ ? step_at_cutoff_ * (cutoff2_ / r2) * (4.0 - 6.0 * s / shell_) / shell_ : 0.0;
    }

    Pair pair_;
    double cutoff2_;
    double shell_;                ///< b
    PairTerm<double> at_cutoff_;  ///< its limit from inside
    double step_at_cutoff_;       ///< -rc y(rc)
};

}  // namespace

PairCurvature& PairCurvature::operator+=(const PairCurvature& other) {
    energy += other.energy;
    hypervirial += other.hypervirial;
    laplacian += other.laplacian;
    return *this;
}

PairCurvature pair_curvature(const State& state, const PairPotential& potential) {
    const double cutoff = potential.cutoff().radius;
    const PairsWithin pairs(state, cutoff);
    return potential.visit([&](const auto& pair) {
        const CurvatureOfPair of_pair(pair, cutoff);
        const auto sum_of_part = [&](Index part, Index) {
            PairCurvature sum;
            pairs.for_each(part, [&](const Neighbor& near) {
                // A pair of two atoms in the box is met twice, and taken once; one with an image is met from both
                // sides, each time as a half.
                const bool is_image = near.j >= pairs.atoms().count();
                if (!is_image && near.i > near.j) {
                    return;
                }
                PairCurvature term = of_pair(near.r2);
                if (is_image) {
                    term.energy *= 0.5;
                    term.hypervirial *= 0.5;
                    term.laplacian *= 0.5;
                }
                sum += term;
            });
            return sum;
        };
        return join_blocks(state.execution(), pairs.part_count(), 1, PairCurvature{}, sum_of_part,
                           [](PairCurvature& sum, const PairCurvature& part) { sum += part; });
    });
}

}  // namespace ljmd
