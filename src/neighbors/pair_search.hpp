#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "neighbors/all_pairs.hpp"
#include "neighbors/linked_cells.hpp"
#include "neighbors/verlet_list.hpp"

namespace ljmd {

/// Searches for the neighbours of every atom. Each has
///
///     void prepare(State&, double cutoff)
///         makes the search valid for the present positions; may wrap and reorder atoms and replace ghosts;
///     Index part_count(const State&) const, AtomRange atoms_of(const State&, Index part) const
///         parts into which the atoms are split, for threads to share; no atom belongs to two;
///     void for_each_candidate(const State&, Index part, visit) const
///         calls visit(PairVisit) for all pairs of an atom i of the part with every j != i that can be closer than the
///         cutoff. Either each pair is visited once from each side, and j may be a ghost; or it is visited only once,
///         and j is an atom of any part (PairVisit::once). Candidates beyond the cutoff must be expected;
///     const SearchStatistics& statistics() const;
///     void archive(Archive&, State&, double cutoff)
///         reads or writes what a later evaluation depends on.
///
/// @pre for all: cutoff <= L/2, so that an atom has at most one image of another one within the cutoff.
using PairSearch = std::variant<AllPairs, LinkedCells, VerletList>;

/// The names of the searches, as `[neighbors] method` takes them.
[[nodiscard]] std::vector<std::string> pair_search_names();

/// @param skin   added to the cutoff as the radius of the list [sigma], >= 0; only `verlet-list` uses it
/// @param every  number of evaluations to keep each list for, see VerletList; only `verlet-list` uses it
/// @param tile   atoms of a tile, see ClusterGrid::configure(); only `verlet-list` uses it
/// @throws InputError for an unknown name
[[nodiscard]] PairSearch make_pair_search(const std::string& name, double skin,
                                          std::optional<Index> every = std::nullopt,
                                          std::optional<Index> tile = std::nullopt);

}  // namespace ljmd
