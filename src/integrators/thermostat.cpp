#include "integrators/thermostat.hpp"

#include "ljmd/options/choice.hpp"

namespace ljmd {

ThermostatMethod find_thermostat(const std::string& name) {
    return find_plugin(all_thermostats(), name, "thermostat");
}

ChosenThermostat chosen_thermostat(const Choice& choice) {
    return chosen(all_thermostats(), choice, "thermostat");
}

}  // namespace ljmd
