#include "forces/few_body_force.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/options/choice.hpp"

namespace ljmd {

AngularVelocity FewBodyForceOptions::angular_velocity(double /*distance*/, double /*distance_rate*/) const {
    throw ContractViolation("this force has no polar angle");
}

FewBodyForceMethod find_few_body_force(const std::string& name) {
    return find_plugin(all_few_body_forces(), name, "few-body force");
}

ChosenFewBodyForce chosen_few_body_force(const Choice& choice) {
    return chosen(all_few_body_forces(), choice, "few-body force");
}

}  // namespace ljmd
