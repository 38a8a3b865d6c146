#pragma once

#include <string>
#include <vector>

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// A pair potential that is known by a table, as plain values: from the same values it is made with the same bits.
struct TabulatedPair {
    std::string name = {};
    std::string truncation = {};        ///< one of PairPotential::truncation_names()
    Cutoff cutoff = {};                 ///< its radius is also the last distance of the table
    double first = 0.0;                 ///< the first distance of the table [sigma]
    std::vector<double> energies = {};  ///< without truncation, see PairTable [epsilon]
    double error = 0.0;                 ///< of an energy, stated by whoever made the table, in units of 1 + |u|
    double force_error = 0.0;           ///< of -du/dr, in units of 1 + |du/dr|

    /// @throws InputError as PairTable and PairPotential::custom()
    [[nodiscard]] PairPotential potential() const;
};

}  // namespace ljmd
