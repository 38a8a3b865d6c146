#pragma once

#include <string>
#include <vector>

#include "ljmd/detail/options/description.hpp"
#include "ljmd/engine/stage.hpp"

namespace ljmd {

/// A body at its start, in the numbers that its force takes: lengths, or an angle or a distance.
struct BodyStart {
    double mass = 0.0;
    std::vector<double> position;  ///< one to three components, as many for all bodies
    std::vector<double> velocity;

    void describe(Description& description);
};

/// What a run of few bodies in unbounded space is, as plain values in whatever units go together.
struct FewBodySpec {
    Choice force = {};                   ///< see few_body_force()
    std::vector<BodyStart> bodies = {};  ///< at least one
    std::vector<Stage> stages = {};
    Index sample_every = 1;             ///< steps between samples of energy and momenta
    std::vector<Choice> analyses = {};  ///< see few_body_analysis()
};

/// Sentences on all that is wrong with a specification; empty if a run can begin.
[[nodiscard]] std::vector<std::string> mistakes(const FewBodySpec& spec);

}  // namespace ljmd
