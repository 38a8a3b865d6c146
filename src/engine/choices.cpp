#include "ljmd/engine/choices.hpp"

#include "ljmd/core/registry.hpp"
#include "ljmd/core/section.hpp"

namespace ljmd {

namespace {

template <class Plugin>
auto chosen(const Plugin& plugin, const Settings& settings) {
    return choose(plugin, checked_settings(plugin.name, keys_of(plugin), settings));
}

}  // namespace

ChosenIntegrator integrator(const std::string& name, const Settings& settings) {
    return chosen(find_integrator(name), settings);
}

ChosenThermostat thermostat(const std::string& name, const Settings& settings) {
    return chosen(find_thermostat(name), settings);
}

ChosenBarostat barostat(const std::string& name, const Settings& settings) {
    return chosen(find_barostat(name), settings);
}

ChosenAnalysis analysis(const std::string& name, const Settings& settings) {
    return chosen(find_plugin(all_analyses(), name, "analysis"), settings);
}

}  // namespace ljmd
