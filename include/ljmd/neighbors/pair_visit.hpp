#pragma once

#include <algorithm>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// What a search shows of a pair, see PairSearch.
struct PairVisit {
    Index i;
    Index j;
    double dx, dy, dz;  ///< r_i - r_j of the nearest image [sigma]
    bool once;          ///< this is the pair's only visit and stands for j, too, which may be an atom of another part;
                        ///< else j meets i in one of its own
};

/// Atoms [first, last).
struct AtomRange {
    Index first;
    Index last;
    [[nodiscard]] Index count() const { return last - first; }
};

/// Parts of equal length, for searches that show each pair from both sides.
struct EqualParts {
    static constexpr Index length = 64;
    static Index count(Index atoms) { return (atoms + length - 1) / length; }
    static AtomRange atoms(Index part, Index atoms) { return {part * length, std::min((part + 1) * length, atoms)}; }
};

}  // namespace ljmd
