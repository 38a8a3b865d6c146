#pragma once

#include <catch2/catch.hpp>
#include <map>
#include <optional>
#include <string>

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd::test {

/// Values for the parameters that formulas demand, for tests to which they do not matter.
inline const std::map<std::string, double> usual_parameters{
    {"well_depth", 1.0}, {"steepness", 6.0}, {"minimum", 1.122462048309373}};

/// A potential as a deck's [potential] makes it. Parameters that are not given take usual values.
/// @param numbers  keys of the formula, e.g. {"steepness", 5.0}
inline PairPotential potential_from_deck(const std::string& formula, const std::string& truncation,
                                         const Cutoff& cutoff, const std::map<std::string, double>& numbers = {}) {
    Table table{{"type", {}, {formula, {}}}, {"truncation", {}, {truncation, {}}}, {"cutoff", {}, {cutoff.radius, {}}}};
    if (truncation == "switched") {
        table.push_back({"switch_start", {}, {cutoff.switch_start, {}}});
    }
    for (const auto& [key, number] : numbers) {
        table.push_back({key, {}, {number, {}}});
    }
    for (const Key& key : PairPotential::formula_keys(formula)) {
        if (key.required && find(table, key.name) == nullptr) {
            table.push_back({key.name, {}, {usual_parameters.at(key.name), {}}});
        }
    }
    const Schema schema = Schema("[potential]", {Key::text("type"), Key::text("truncation"), Key::number("cutoff")})
                              .with(PairPotential::formula_keys(formula))
                              .with(PairPotential::truncation_keys(truncation));
    Diagnostics diagnostics;
    const Section section = validate(table, {}, schema, std::nullopt, diagnostics);
    REQUIRE_NOTHROW(diagnostics.throw_if_errors());
    return PairPotential::from(section);
}

}  // namespace ljmd::test
