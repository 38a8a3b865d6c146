#pragma once

#include <map>
#include <optional>
#include <string>

#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "options/placed.hpp"

namespace ljmd {

/// [potential]: formula and truncation by name, and the radii of the truncation.
struct PotentialTable : Cutoff {
    std::string type;
    std::string truncation;
    std::optional<bool> tail;
    std::map<std::string, PairPotential::Parameters> parameters;  ///< by formula; the ones of `type` have values

    void describe(TableDescription& description);

    [[nodiscard]] bool has_tail() const { return tail.value_or(false); }
};

/// The potential of a deck. @pre cutoff > 0; for `switched` 0 < switch_start < cutoff
[[nodiscard]] PairPotential pair_potential_of(const PotentialTable& table);

/// The table of a specification. @pre its potential is none of the program's own
[[nodiscard]] PotentialTable potential_table(const FluidSpec& spec);

}  // namespace ljmd
