#pragma once

#include "judge/explanations.hpp"
#include "judge/joint_diagnosis.hpp"

namespace ljmd {

/// Offer mistakes of single pairs and atoms, told by the forces: pairs that are left out; an atom whose pairs are all
/// stronger or weaker by one factor, or left out; a force on one atom that alone is wrong.
/// @param tolerance  of relative differences that are none
void offer_odd_pairs(const Fluid& fluid, const ExpectedPoint& expected, const PointAnswer& answer,
                     const AnswerParts& parts, double tolerance, Explanations& known);

/// Offer the sums that a start of fewer digits has: of its positions, or of the edges of the box.
void offer_digits_of_start(const Fluid& fluid, const AnswerParts& parts, Explanations& known);

}  // namespace ljmd
