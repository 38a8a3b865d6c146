#include "neighbors/ghost_routes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "execution/rank_messages.hpp"

namespace ljmd {

namespace {

/// Ghost clusters of another rank, as its messages name them.
struct Named {
    std::int32_t column;   ///< number at the rank that has the atoms
    std::int32_t cluster;  ///< number of the first one within the column
    std::int32_t clusters;
};

}  // namespace

void GhostRoutes::find(const ClusterGrid& grid, std::span<const std::span<const ClusterGrid::GhostClusters>> ghosts,
                       Ranks& ranks) {
    const auto tiles = grid.tiles();
    const auto size = static_cast<std::size_t>(ranks.size());
    // A GhostClusters is of one column, so of one tile.
    const auto tile_of_atom = [&](std::uint32_t atom) {
        const auto after =
            std::upper_bound(tiles.begin(), tiles.end(), Index{atom},
                             [&](Index a, const ClusterGrid::Run& tile) { return a < grid.atoms_of(tile).first; });
        return static_cast<std::size_t>(after - tiles.begin()) - 1;
    };

    std::vector<Export> found;  // of the tiles here, in their order
    std::vector<std::vector<Named>> names(size);
    std::vector<ToRank> to(size);
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        for (const ClusterGrid::GhostClusters& each : ghosts[t]) {
            // Only the last cluster of a column may have slots without an atom, so atoms and slots run in step.
            const AtomRange atoms = grid.atoms_of(each.of);
            const Export one{
                static_cast<std::int32_t>(t),
                static_cast<std::uint32_t>(3 * ClusterGrid::slots * (each.first - ghosts[t].front().first)),
                static_cast<std::uint32_t>(atoms.first), static_cast<std::uint32_t>(atoms.count())};
            if (!grid.is_abroad(each.of.first)) {
                found.push_back(one);
                continue;
            }
            const ClusterGrid::Abroad there = grid.abroad(each.of.first);
            names[static_cast<std::size_t>(there.rank)].push_back({there.column, there.cluster, each.of.length()});
            to[static_cast<std::size_t>(there.rank)].exports.push_back(one);
        }
    }
    to_.clear();
    from_.clear();
    std::vector<Export> all;
    if (ranks.alone()) {
        all = std::move(found);
    } else {
        std::vector<Ranks::Bytes> messages;
        for (std::size_t rank = 0; rank < size; ++rank) {
            messages.push_back(message_of(names[rank]));
            std::size_t numbers = 0;
            for (const Export& one : to[rank].exports) {
                numbers += std::size_t{3} * one.count;
            }
            if (numbers > 0) {
                to[rank].rank = static_cast<int>(rank);
                to[rank].forces.resize(numbers);
                to_.push_back(std::move(to[rank]));
            }
        }
        const std::vector<Ranks::Bytes> received = ranks.exchange(std::move(messages));
        std::size_t numbers = 0;
        for (std::size_t rank = 0; rank < size; ++rank) {
            if (static_cast<int>(rank) == ranks.rank()) {
                all.insert(all.end(), found.begin(), found.end());
                continue;
            }
            const std::size_t before = numbers;
            for (const Named& each : values_of<Named>(received[rank])) {
                const std::int32_t first = grid.clusters_of_column(each.column).first + each.cluster;
                const AtomRange atoms = grid.atoms_of({first, first + each.clusters});
                all.push_back({-1, static_cast<std::uint32_t>(numbers), static_cast<std::uint32_t>(atoms.first),
                               static_cast<std::uint32_t>(atoms.count())});
                numbers += static_cast<std::size_t>(3 * atoms.count());
            }
            if (numbers > before) {
                from_.push_back({static_cast<int>(rank), before, numbers - before});
            }
        }
        received_.resize(numbers);
    }

    // Counting sort by the tile of the atoms: starts_[t + 1] is the next free place of tile t while exports_ is filled.
    starts_.assign(tiles.size() + 2, 0);
    for (const Export& one : all) {
        ++starts_[tile_of_atom(one.first) + 2];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    exports_.resize(all.size());
    for (const Export& one : all) {
        exports_[starts_[tile_of_atom(one.first) + 1]++] = one;
    }
    starts_.pop_back();
}

void GhostRoutes::begin_exchange(Ranks& ranks, std::span<const AlignedVector<double>> ghost_forces) {
    if (ranks.alone()) {
        return;
    }
    std::vector<Ranks::Outgoing> outgoing;
    for (ToRank& to : to_) {
        auto next = to.forces.begin();
        for (const Export& one : to.exports) {
            const auto from = ghost_forces[static_cast<std::size_t>(one.tile)].begin() + one.offset;
            next = std::copy(from, from + std::ptrdiff_t{3} * one.count, next);
        }
        outgoing.push_back({to.rank, to.forces});
    }
    std::vector<Ranks::Incoming> incoming;
    for (const FromRank& from : from_) {
        incoming.push_back({from.rank, {received_.data() + from.first, from.count}});
    }
    ranks.begin_exchange(outgoing, incoming);
}

}  // namespace ljmd
