#include "neighbors/missed_pairs.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "execution/loops.hpp"
#include "neighbors/columns_around.hpp"

namespace ljmd {

namespace {

/// Widens the cutoff, because mixed precision rounds positions.
constexpr double wider = 1.0 + 0x1p-21;

/// With fewer atoms per fast atom, a rebuild costs less than a search around all fast atoms.
constexpr Index min_atoms_per_fast_atom = 64;

constexpr Index fast_atoms_per_block = 16;

double squared_distance(const double* a, const double* b, const Vec3& shift) {
    const double dx = a[0] - b[0] - shift[0];
    const double dy = a[1] - b[1] - shift[1];
    const double dz = a[2] - b[2] - shift[2];
    return dx * dx + dy * dy + dz * dz;
}

struct Move {
    Index atom;
    double length;  ///< [sigma]
};

/// Displacements of atoms since they were sorted.
struct Moves {
    std::vector<Move> fast;          ///< atoms that are not slow, in their order, NaN and atoms of the halo included
    std::vector<double> of_column;   ///< longest of each column [sigma]
    std::vector<double> of_cluster;  ///< longest of each cluster [sigma]
};

/// @param slow  largest displacement of a slow atom [sigma]
Moves find_moves(const ClusterGrid& grid, const double* before, const State& state, double slow) {
    const double* now = state.positions().data();
    Moves moves;
    moves.of_column.resize(static_cast<std::size_t>(grid.column_count()));
    moves.of_cluster.resize(static_cast<std::size_t>(grid.cluster_count()));
    const auto fast_in_columns = [&](Index first, Index last) {
        std::vector<Move> fast;
        for (Index column = first; column < last; ++column) {
            const ClusterGrid::Run clusters = grid.clusters_of_column(static_cast<std::int32_t>(column));
            double longest2_of_column = 0.0;
            for (Index cluster = clusters.first; cluster < clusters.last; ++cluster) {
                const AtomRange atoms = grid.atoms_of_cluster(cluster);
                double longest2 = 0.0;
                for (Index i = atoms.first; i < atoms.last; ++i) {
                    const double length2 = squared_displacement(now, before, i);
                    longest2 = std::max(longest2, length2);
                    if (!(length2 <= slow * slow)) {
                        fast.push_back({i, std::sqrt(length2)});
                    }
                }
                moves.of_cluster[static_cast<std::size_t>(cluster)] = std::sqrt(longest2);
                longest2_of_column = std::max(longest2_of_column, longest2);
            }
            moves.of_column[static_cast<std::size_t>(column)] = std::sqrt(longest2_of_column);
        }
        return fast;
    };
    moves.fast = join_blocks(
        state.execution(), grid.column_count(), ClusterGrid::columns_per_block, std::vector<Move>{}, fast_in_columns,
        [](std::vector<Move>& all, const std::vector<Move>& next) { all.insert(all.end(), next.begin(), next.end()); });
    return moves;
}

}  // namespace

bool any_pair_missed(const ClusterGrid& grid, const double* before, const State& state, double cutoff, double skin) {
    const double* now = state.positions().data();
    const double reach = cutoff * wider;
    const double range = (cutoff + skin) * (1.0 - 0x1p-40);  // all pairs within it are on the list
    const double harmless = std::max(0.0, range - reach);  // total displacement of a pair that cannot have been missed
    const Moves moves = find_moves(grid, before, state, 0.5 * harmless);

    Ranks& ranks = state.execution().ranks();
    std::int64_t fast_atoms = 0;  // of this rank alone
    double longest = 0.0;
    for (const Move& move : moves.fast) {
        fast_atoms += move.atom < state.count() ? 1 : 0;
        longest = std::isnan(move.length) ? std::numeric_limits<double>::infinity() : std::max(longest, move.length);
    }
    ranks.sum({&fast_atoms, 1});
    ranks.largest({&longest, 1});
    if (fast_atoms * min_atoms_per_fast_atom > state.total() || longest > skin) {
        return true;
    }

    // Of two atoms of different ranks only one rank has both, so the surroundings of fast atoms of the halo are
    // searched, too.
    const auto missed_around = [&](ColumnsAround& around, const Move& move) {
        const double* here = now + vector_stride * move.atom;
        const double* there = before + vector_stride * move.atom;
        const double enough = harmless - move.length;  // displacement that a partner needs to have been missed
        return around.any(Vec3(here[0], here[1], here[2]), reach + longest,
                          [&](std::int32_t column, const Vec3& shift) {
                              if (moves.of_column[static_cast<std::size_t>(column)] < enough) {
                                  return false;
                              }
                              const ClusterGrid::Run clusters = grid.clusters_of_column(column);
                              for (Index cluster = clusters.first; cluster < clusters.last; ++cluster) {
                                  if (moves.of_cluster[static_cast<std::size_t>(cluster)] < enough) {
                                      continue;
                                  }
                                  const AtomRange atoms = grid.atoms_of_cluster(cluster);
                                  for (Index j = atoms.first; j < atoms.last; ++j) {
                                      if (squared_distance(here, now + vector_stride * j, shift) < reach * reach &&
                                          squared_distance(there, before + vector_stride * j, shift) >= range * range) {
                                          return true;
                                      }
                                  }
                              }
                              return false;
                          });
    };
    std::atomic<bool> missed = false;
    for_each_block(state.execution(), static_cast<Index>(moves.fast.size()), fast_atoms_per_block,
                   [&](Index first, Index last) {
                       ColumnsAround around(grid);
                       for (Index k = first; k < last && !missed; ++k) {
                           if (missed_around(around, moves.fast[static_cast<std::size_t>(k)])) {
                               missed = true;
                           }
                       }
                   });
    std::int64_t ranks_that_missed = missed ? 1 : 0;
    ranks.sum({&ranks_that_missed, 1});
    return ranks_that_missed > 0;
}

}  // namespace ljmd
