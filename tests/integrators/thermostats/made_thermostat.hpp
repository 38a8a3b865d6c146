#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ljmd/integrators/thermostat.hpp"

namespace ljmd::test {

/// A thermostat as a stage makes it. Keys that are not given take their defaults.
/// @param integers  keys of the thermostat, e.g. {"every", 10}
inline std::unique_ptr<Thermostat> made_thermostat(const std::string& name, double temperature,
                                                   const std::vector<std::pair<std::string, std::int64_t>>& integers) {
    const ThermostatMethod method = find_thermostat(name);
    Table table;
    for (const auto& [key, value] : integers) {
        table.push_back({key, {}, {value, {}}});
    }
    Diagnostics diagnostics;
    const Section section = validate(table, {}, Schema("thermostat", method.keys), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    return method.make(section, temperature);
}

}  // namespace ljmd::test
