#pragma once

#include <vector>

#include "engine/mistakes/mistakes.hpp"
#include "forces/few_body_force.hpp"
#include "ljmd/detail/engine/few_body_spec.hpp"

namespace ljmd {

// The rules for few bodies, beside those for stages of all kinds of runs. As in mistakes.hpp each function knows a
// part.

/// Vectors with another number of components than the first one. What has none was found wrong already.
[[nodiscard]] std::vector<Mistake> dimension_mistakes(const std::vector<BodyStart>& bodies);

/// A space in which the force does not act. @pre dimension_mistakes() finds none, and there is a body
[[nodiscard]] std::vector<Mistake> force_mistakes(const std::vector<BodyStart>& bodies,
                                                  const FewBodyForceMethod& force);

/// A start at which the force has no value, such as two bodies in one place. @pre force_mistakes() finds none
[[nodiscard]] std::vector<Mistake> start_mistakes(const std::vector<BodyStart>& bodies,
                                                  const ChosenFewBodyForce& force);

/// Options of analyses that do not fit the bodies and their force. @pre as start_mistakes()
[[nodiscard]] std::vector<Mistake> few_body_analysis_mistakes(const std::vector<Choice>& analyses,
                                                              const std::vector<BodyStart>& bodies,
                                                              const ChosenFewBodyForce& force);

}  // namespace ljmd
