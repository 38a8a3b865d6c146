#pragma once

#include <vector>

#include "potentials/made_potential.hpp"

namespace ljmd::test {

inline constexpr Cutoff usual_cutoff{2.5, 2.0};

/// Every formula with every truncation.
inline std::vector<PairPotential> every_potential() {
    std::vector<PairPotential> potentials;
    for (const std::string& formula : PairPotential::formula_names()) {
        for (const std::string& truncation : PairPotential::truncation_names()) {
            potentials.push_back(made_potential(formula, truncation, usual_cutoff));
        }
    }
    return potentials;
}

}  // namespace ljmd::test
