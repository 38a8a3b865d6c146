#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ljmd/core/section.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// Acts on velocities between steps to hold a temperature.
class Thermostat {
  public:
    virtual ~Thermostat() = default;

    /// Called after every step of its stage.
    /// @param step_of_stage  1 after the first step
    virtual void apply(State& state, Index step_of_stage) = 0;
};

/// A kind of thermostat that decks can select. One file in src/integrators/thermostats each.
struct ThermostatMethod {
    std::string name;
    std::string meaning;
    std::vector<Key> keys;  ///< beside `type`
    std::function<std::unique_ptr<Thermostat>(const Section&, double temperature)> make;
};

/// Every thermostat there is, in alphabetical order.
[[nodiscard]] std::vector<ThermostatMethod> all_thermostats();

/// @throws InputError for an unknown name
[[nodiscard]] ThermostatMethod find_thermostat(const std::string& name);

}  // namespace ljmd
