#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ljmd/neighbors/all_pairs.hpp"
#include "ljmd/neighbors/linked_cells.hpp"
#include "ljmd/neighbors/verlet_list.hpp"

namespace ljmd {

/// Ways to find the neighbours of every atom. All have
///
///     void prepare(State&, double cutoff)
///         make the search valid for the present positions: may wrap and reorder atoms and replace ghosts;
///     void for_each_candidate(const State&, Index i, visit) const
///         call visit(j, dx, dy, dz) with d = r_i - r_j (nearest image) for every j != i that can be closer than the
///         cutoff; each pair is seen from both sides; candidates beyond the cutoff must be expected;
///     const SearchStatistics& statistics() const.
///
/// @pre for all: cutoff <= L/2, so that no atom meets two images of another one within the cutoff.
using PairSearch = std::variant<AllPairs, LinkedCells, VerletList>;

/// The names that [neighbors] method takes, with their meaning.
[[nodiscard]] std::vector<std::string> pair_search_names();

/// @param skin   extra radius of the list [sigma], >= 0; only `verlet-list` uses it
/// @param every  keep each list for that many evaluations, see VerletList; only `verlet-list` uses it
/// @throws InputError for an unknown name
[[nodiscard]] PairSearch make_pair_search(const std::string& name, double skin,
                                          std::optional<Index> every = std::nullopt);

}  // namespace ljmd
