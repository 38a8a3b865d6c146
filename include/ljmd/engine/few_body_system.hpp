#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/forces/few_body_force.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/observables/few_body/few_body_analysis.hpp"

namespace ljmd {

/// The bodies, forces and analyses of a few-body run.
struct FewBodySystem {
    State state;
    int dimensions;
    ChosenFewBodyForce force;
    std::unique_ptr<ForceField> force_field;
    std::vector<std::pair<std::string, std::unique_ptr<FewBodyAnalysis>>> analyses;
};

}  // namespace ljmd
