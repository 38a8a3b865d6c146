#pragma once

#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "execution/test_execution.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/detail/options/section.hpp"
#include "model/velocities.hpp"

namespace ljmd::test {

/// A thermostat as a stage makes it. Keys that are not given take their defaults.
/// @param settings  keys of the thermostat, e.g. {"every", 10}
inline std::unique_ptr<Thermostat> made_thermostat(
    const std::string& name, const HeatBath& bath,
    const std::vector<std::pair<std::string, std::variant<std::int64_t, double>>>& settings = {}) {
    const ThermostatMethod method = find_thermostat(name);
    Table table;
    for (const auto& [key, value] : settings) {
        std::visit([&, name = key](auto number) { table.push_back({name, {}, {number, {}}}); }, value);
    }
    Diagnostics diagnostics;
    const Section section = validate(table, {}, Schema("thermostat", keys_of(method)), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    return choose(method, section).options->make(bath);
}

/// A bath for all atoms of a fluid.
inline HeatBath bath_of(const State& state, double temperature, double time_step = 0.005) {
    return {temperature, time_step, 1, degrees_of_freedom(state.count())};
}

/// What a thermostat does to the velocities in one step that does not change them otherwise.
inline void act(const Thermostat& thermostat, State& state, Index step) {
    state.step = step - 1;
    thermostat.before_step(state);
    if (thermostat.acts_mid_drift()) {
        thermostat.mid_drift(state);
    }
    state.step = step;
    thermostat.after_step(state, step);
}

/// 100 atoms that move, in the order of their ids or another one.
inline State moving_atoms(double temperature, bool reordered = false, const Execution& execution = test_execution()) {
    State state(100, Box(Vec3::Constant(5.0)), execution);
    draw_velocities(state, temperature, 9);
    if (reordered) {
        std::vector<Index> order;
        for (Index i = 0; i < state.count(); ++i) {
            order.push_back((37 * i + 11) % state.count());
        }
        state.reorder(order);
    }
    state.bath = {0.0};
    return state;
}

}  // namespace ljmd::test
