#pragma once

#include <optional>
#include <string>

#include "judge/point_judgement.hpp"

namespace ljmd {

/// A mistake is found if it explains all of a difference but this part.
inline constexpr double unexplained_of_point = 1e-3;

/// One part of an answer beside a value: how far they are apart, and what is no difference.
struct AnswerPart {
    double off;
    double noise;
    [[nodiscard]] bool is_wrong() const { return !(off <= noise); }
};

/// The parts of an answer that pairs make, to be held against sums of pairs: ours, or sums made with a mistake.
class AnswerParts {
  public:
    /// @param tolerance  of relative differences that are none
    AnswerParts(const ExpectedPoint& expected, const PointAnswer& answer, double tolerance)
        : expected_(expected), answer_(answer), tolerance_(tolerance) {}

    // @pre the answer has the part

    [[nodiscard]] AnswerPart energy(const PairSums& sums) const;
    [[nodiscard]] AnswerPart virial(const PairSums& sums) const;
    [[nodiscard]] AnswerPart forces(const PairSums& sums) const;

    // Whether the answer has the part, and it is not ours.

    [[nodiscard]] bool energy_is_wrong() const { return answer_.potential_energy && energy(expected_.sums).is_wrong(); }
    [[nodiscard]] bool virial_is_wrong() const { return answer_.virial && virial(expected_.sums).is_wrong(); }
    [[nodiscard]] bool forces_are_wrong() const { return !answer_.forces.empty() && forces(expected_.sums).is_wrong(); }

    /// What a mistake leaves of the differences if the sums made with it are these: the largest part of a difference
    /// that is left in any of energy, virial and forces. Nothing if more than a thousandth is left, if nothing was
    /// wrong, or if the answer has one number alone, which a parameter of a mistake can always meet.
    [[nodiscard]] std::optional<double> unexplained(const PairSums& sums) const;

    /// The factor between its forces and ours (least squares), else between the virials; nothing without both.
    [[nodiscard]] std::optional<double> factor() const;

  private:
    const ExpectedPoint& expected_;
    const PointAnswer& answer_;
    double tolerance_;
};

/// The mistake that explains most of energy, virial and forces of an answer together: of epsilon, sigma, images,
/// cutoff, of one atom or pair, or of the digits of the start. Nothing if none does.
[[nodiscard]] std::optional<std::string> joint_mistake(const Fluid& fluid, const ExpectedPoint& expected,
                                                       const PointAnswer& answer, double tolerance);

}  // namespace ljmd
