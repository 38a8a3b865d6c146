#include "ljmd/integrators/thermostat.hpp"

#include "ljmd/core/registry.hpp"

namespace ljmd {

ThermostatMethod find_thermostat(const std::string& name) {
    return find_plugin(all_thermostats(), name, "thermostat");
}

}  // namespace ljmd
