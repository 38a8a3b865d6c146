#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/engine/observer.hpp"
#include "potentials/tabulated_pair.hpp"

namespace ljmd {

/// A pair potential that a program gave to a run. The [potential] of the deck stands in for it: only its cutoff and its
/// truncation count.
struct GivenPotential {
    std::string name;
    std::string truncation;
    Cutoff cutoff;
    std::string checksum;                     ///< of its table, or of some of its values
    std::optional<TabulatedPair> table = {};  ///< if it has one: the run keeps it in its directory
    std::optional<PairPotential> potential = {};
    std::string missing = {};  ///< why there is no potential
    bool bad_table = false;    ///< it had a table, which cannot be used

    /// @throws DataError  the potential is missing
    [[nodiscard]] const PairPotential& known() const {
        if (!potential) {
            throw DataError(missing);
        }
        return *potential;
    }
};

/// What a program gave to a run beside its deck. The command line gives nothing.
struct GivenParts {
    std::string by = {};  ///< the language of the program: "Python" or "C++"
    std::optional<GivenPotential> potential = {};
    std::vector<ObserverRecord> observers = {};
    std::string external = {};  ///< the name of its external force; empty: none

    [[nodiscard]] bool empty() const { return !potential && observers.empty() && external.empty(); }
};

}  // namespace ljmd
