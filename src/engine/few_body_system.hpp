#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "forces/few_body_force.hpp"
#include "ljmd/detail/engine/few_body_spec.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"
#include "observables/few_body/few_body_analysis.hpp"

namespace ljmd {

/// The bodies, forces and analyses of a few-body run.
struct FewBodySystem {
    State state;
    int dimensions;
    ChosenFewBodyForce force;
    std::unique_ptr<ForceField> force_field;
    std::vector<std::pair<std::string, std::unique_ptr<FewBodyAnalysis>>> analyses;
};

/// The bodies at their start, without a box; ids in their order. Masses are the inertia that the force assigns.
/// @pre positions and velocities have one to three components
[[nodiscard]] State few_body_start(const std::vector<BodyStart>& bodies, const FewBodyForceOptions& force,
                                   const Execution& execution = {});

/// The system at its start.
/// @pre there is a body, and all have as many components as the force takes
/// @throws InputError for a force, an analysis or an option that is not known
[[nodiscard]] FewBodySystem make_few_body_system(const FewBodySpec& spec, const Execution& execution = {});

}  // namespace ljmd
