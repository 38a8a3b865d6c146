#pragma once

#include <map>
#include <string>

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd::test {

/// Values for parameters that formulas demand, for tests to which they do not matter. Others are 1.
inline const std::map<std::string, double> default_parameters{
    {"well_depth", 1.0}, {"steepness", 6.0}, {"minimum", 1.122462048309373}};

/// A potential by its name. Parameters that are not given take usual values.
/// @param numbers  keys of the formula, e.g. {"steepness", 5.0}
inline PairPotential made_potential(const std::string& formula, const std::string& truncation, const Cutoff& cutoff,
                                    const std::map<std::string, double>& numbers = {}) {
    PairPotential::Parameters parameters;
    for (const Key& key : PairPotential::formula_keys(formula)) {
        const auto given = numbers.find(key.name);
        const auto usual = default_parameters.find(key.name);
        const double otherwise = usual != default_parameters.end() ? usual->second : 1.0;
        parameters.emplace_back(key.name, given != numbers.end() ? given->second : otherwise);
    }
    return PairPotential::make(formula, truncation, cutoff, parameters);
}

}  // namespace ljmd::test
