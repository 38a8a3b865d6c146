#pragma once

#include <algorithm>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// A pair as a search passes it to its visitor, see PairSearch.
struct PairVisit {
    Index i;
    Index j;
    double dx, dy, dz;  ///< r_i - r_j of the nearest image [sigma]
    bool once;  ///< true: this is the only visit of the pair and counts for j, too, which may be of another part;
                ///< false: j visits i in turn
    bool upper = false;  ///< j lies in the upper half of its cluster: visits to one half come in an order that all
                         ///< lists have, whatever the shape of their rows
};

/// Atoms [first, last).
struct AtomRange {
    Index first;
    Index last;
    [[nodiscard]] Index count() const { return last - first; }
};

/// Parts of equal length, for searches that visit each pair from both sides.
struct EqualParts {
    static constexpr Index length = 64;
    static Index count(Index atoms) { return (atoms + length - 1) / length; }
    static AtomRange atoms(Index part, Index atoms) { return {part * length, std::min((part + 1) * length, atoms)}; }
};

}  // namespace ljmd
