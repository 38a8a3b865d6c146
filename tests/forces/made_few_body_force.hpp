#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "forces/few_body_force.hpp"
#include "ljmd/detail/options/section.hpp"

namespace ljmd::test {

using Numbers = std::vector<std::pair<std::string, double>>;

/// The table of a few-body force as a deck gives it, validated. @throws InputError when a number is not allowed
inline Section few_body_section(const std::string& name, const Numbers& numbers) {
    Table table;
    for (const auto& [key, value] : numbers) {
        table.push_back({key, {}, {value, {}}});
    }
    Diagnostics diagnostics;
    const Section section =
        validate(table, {}, Schema("[force]", keys_of(find_few_body_force(name))), std::nullopt, diagnostics);
    diagnostics.throw_if_errors();
    return section;
}

inline ChosenFewBodyForce chosen_few_body_force(const std::string& name, const Numbers& numbers) {
    const Section section = few_body_section(name, numbers);
    return choose(find_few_body_force(name), section);
}

inline std::unique_ptr<ForceField> made_few_body_force(const std::string& name, const Numbers& numbers) {
    return chosen_few_body_force(name, numbers).options->make();
}

/// What the check of a start says.
inline std::optional<ProblemAtStart> problem_at_start(const std::string& name, const Numbers& numbers,
                                                      const State& start) {
    return chosen_few_body_force(name, numbers).options->check(start);
}

/// Bodies at rest in unbounded space.
inline State bodies_at(const std::vector<Vec3>& positions, const std::vector<double>& masses) {
    State state(static_cast<Index>(positions.size()));
    for (std::size_t i = 0; i < positions.size(); ++i) {
        state.write_positions().col(static_cast<Index>(i)) = positions[i];
    }
    state.write_masses() = masses;
    return state;
}

}  // namespace ljmd::test
