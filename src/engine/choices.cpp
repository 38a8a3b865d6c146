#include "ljmd/engine/choices.hpp"

#include "forces/few_body_force.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/options/choice.hpp"
#include "observables/few_body/few_body_analysis.hpp"

namespace ljmd {

Choice integrator(const std::string& name, const Settings& settings) {
    return choice_of(chosen_integrator({name, settings}));
}

Choice thermostat(const std::string& name, const Settings& settings) {
    return choice_of(chosen_thermostat({name, settings}));
}

Choice barostat(const std::string& name, const Settings& settings) {
    return choice_of(chosen_barostat({name, settings}));
}

Choice analysis(const std::string& name, const Settings& settings) {
    return choice_of(chosen_analysis({name, settings}));
}

Choice few_body_force(const std::string& name, const Settings& settings) {
    return choice_of(chosen_few_body_force({name, settings}));
}

Choice few_body_analysis(const std::string& name, const Settings& settings) {
    return choice_of(chosen_few_body_analysis({name, settings}));
}

}  // namespace ljmd
