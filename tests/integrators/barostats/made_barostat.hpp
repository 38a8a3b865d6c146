#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "integrators/barostat.hpp"
#include "ljmd/detail/options/section.hpp"
#include "model/velocities.hpp"

namespace ljmd::test {

using BarostatSettings = std::vector<std::pair<std::string, std::variant<std::int64_t, double, std::string>>>;

/// A barostat as a stage makes it. Keys that are not given take their defaults.
inline std::unique_ptr<Barostat> made_barostat(const std::string& name, const PressureBath& bath,
                                               const BarostatSettings& settings) {
    const BarostatMethod method = find_barostat(name);
    Table table;
    for (const auto& [key, value] : settings) {
        std::visit([&, key = key](const auto& setting) { table.push_back({key, {}, {setting, {}}}); }, value);
    }
    Diagnostics diagnostics;
    const Section section = validate(table, {}, Schema("barostat", keys_of(method)), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    return choose(method, section).options->make(bath);
}

/// Moving atoms in a box of 4 x 5 x 6 sigma^3.
inline State atoms_in_box(Index atoms) {
    State state(atoms, Box(Vec3(4.0, 5.0, 6.0)));
    for (Index i = 0; i < atoms; ++i) {
        state.write_positions().col(i) = state.snapped(Vec3(0.1, 0.2, 0.25) * static_cast<double>(i));
    }
    draw_velocities(state, 1.3, 2);
    return state;
}

}  // namespace ljmd::test
