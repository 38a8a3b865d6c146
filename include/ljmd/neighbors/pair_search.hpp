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
///     Index part_count(const State&) const, AtomRange atoms_of(const State&, Index part) const
///         parts that the atoms are split into, for threads to share; no atom is in two;
///     void for_each_candidate(const State&, Index part, visit) const
///         call visit(PairVisit) for all pairs of an atom i of the part with every j != i that can be closer than the
///         cutoff. A pair comes either once from each side, and j may then be a ghost, or once for both, and j is then
///         of the same part. Candidates beyond the cutoff must be expected;
///     const SearchStatistics& statistics() const;
///     void archive(Archive&, const State&, double cutoff)
///         what an evaluation leaves to the next one.
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
