#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "execution/loops.hpp"
#include "execution/rank_messages.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/cluster_grid.hpp"

// A grid whose tiles are shared among ranks: who has which tile, and which columns of others are near.

namespace ljmd {

namespace {

/// The first tile of each rank, and the number of tiles: runs of about the same work.
/// @param work  of each tile, or of another number of tiles: then all are alike
std::vector<Index> first_tiles(const std::vector<std::int64_t>& work, Index tiles, int ranks) {
    std::vector<Index> first;
    if (static_cast<Index>(work.size()) != tiles) {
        for (int rank = 0; rank <= ranks; ++rank) {
            first.push_back(even_share(tiles, rank, ranks).first);
        }
        return first;
    }
    const std::int64_t all = std::accumulate(work.begin(), work.end(), std::int64_t{0});
    std::int64_t before = 0;  // of the tiles before this one
    for (Index tile = 0; tile < tiles; ++tile) {
        // A rank begins with the tile whose middle is the first one behind the end of its predecessor's share.
        const double middle =
            static_cast<double>(before) + 0.5 * static_cast<double>(work[static_cast<std::size_t>(tile)]);
        while (static_cast<int>(first.size()) < ranks &&
               middle * ranks >= static_cast<double>(all) * static_cast<double>(first.size())) {
            first.push_back(tile);
        }
        before += work[static_cast<std::size_t>(tile)];
    }
    first.resize(static_cast<std::size_t>(ranks) + 1, tiles);
    return first;
}

/// Add the part of a column between two heights over its lowest z.
void add_column(ClusterGrid::HaloPart& to, double area, double low, double high, double height) {
    to.columns += 1;
    to.volume += area * std::max(0.0, std::min(high, height) - std::max(low, 0.0));
    to.cuts += (low > 0.0 ? 1 : 0) + (high < height ? 1 : 0);
}

}  // namespace

void ClusterGrid::share_tiles(const Ranks& ranks, double halo) {
    first_columns_.clear();
    for (const Index tile : first_tiles(work_, tiles_of_all(), ranks.size())) {
        first_columns_.push_back(static_cast<std::int32_t>(tile) * columns_per_tile());
    }
    const auto rank = static_cast<std::size_t>(ranks.rank());
    own_columns_ = {first_columns_[rank], first_columns_[rank + 1]};
    first_tile_ = own_columns_.first / columns_per_tile();
    halo_columns_.clear();
    halo_heights_.clear();
    numbers_here_.clear();
    if (!ranks.alone()) {
        find_halo(halo);
    }
}

int ClusterGrid::rank_of(std::int32_t column) const {
    const auto after = std::upper_bound(first_columns_.begin(), first_columns_.end(), column);
    return static_cast<int>(after - first_columns_.begin()) - 1;
}

/// What a tile sees of the columns of all ranks: those on the side where its ghost clusters lie, see neighborhood().
void ClusterGrid::add_halo_of_tile(std::int32_t tile, double halo, std::vector<Heights>& near) const {
    Cell first = tile_cells_[static_cast<std::size_t>(tile)];
    Cell reach{};
    for (std::size_t a = 0; a < 3; ++a) {
        first[a] *= columns_per_tile_[a];
        reach[a] = static_cast<int>(std::ceil(halo * inverse_width_[static_cast<Index>(a)]));
    }
    Cell cell{};
    for (cell[2] = first[2]; cell[2] <= first[2] + reach[2]; ++cell[2]) {
        const double above = (first[2] - cell[2]) * height_;  // of the tile's floor over the column's
        for (cell[1] = first[1] - reach[1]; cell[1] < first[1] + columns_per_tile_[1] + reach[1]; ++cell[1]) {
            for (cell[0] = first[0] - reach[0]; cell[0] < first[0] + columns_per_tile_[0] + reach[0]; ++cell[0]) {
                const Seen seen = seen_from(first, cell, halo);
                if (seen.side >= 0 && seen.in_range) {
                    Heights& of_column = near[static_cast<std::size_t>(column_of_all(place_of(seen.wrapped)))];
                    of_column.low = std::min(of_column.low, above - halo);
                    of_column.high = std::max(of_column.high, above + height_ + halo);
                }
            }
        }
    }
}

void ClusterGrid::find_halo(double halo) {
    const auto all = static_cast<std::size_t>(first_columns_.back());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<Heights> near(all, Heights{infinity, -infinity});
    for (std::int32_t tile = own_columns_.first / columns_per_tile(); tile < own_columns_.last / columns_per_tile();
         ++tile) {
        add_halo_of_tile(tile, halo, near);
    }
    numbers_here_.assign(all, -1);
    std::int32_t number = own_column_count();
    for (std::size_t column = 0; column < all; ++column) {
        const auto of_all = static_cast<std::int32_t>(column);
        if (own_columns_.first <= of_all && of_all < own_columns_.last) {
            numbers_here_[column] = of_all - own_columns_.first;
        } else if (near[column].low < near[column].high) {
            numbers_here_[column] = number++;
            halo_columns_.push_back(of_all);
            halo_heights_.push_back(near[column]);
        }
    }
}

std::vector<ClusterGrid::HaloPart> ClusterGrid::halo_parts() const {
    std::vector<HaloPart> parts;
    const double area = 1.0 / (inverse_width_[0] * inverse_width_[1]);
    for (std::size_t k = 0; k < halo_columns_.size(); ++k) {
        const int rank = rank_of(halo_columns_[k]);
        if (parts.empty() || parts.back().rank != rank) {
            parts.push_back({rank, 0, 0.0, 0});
        }
        add_column(parts.back(), area, halo_heights_[k].low, halo_heights_[k].high, height_);
    }
    return parts;
}

std::vector<ClusterGrid::HaloPart> ClusterGrid::force_parts() const {
    std::map<int, HaloPart> of_ranks;
    const double area = 1.0 / (inverse_width_[0] * inverse_width_[1]);
    Cell cell{};
    for (std::int32_t column = 0; column < own_column_count(); column += columns_per_tile()) {
        const Cell first = cell_of(column);
        for (cell[2] = first[2]; cell[2] <= first[2] + reach_[2]; ++cell[2]) {
            const double above = (first[2] - cell[2]) * height_;  // of the tile's floor over the column's
            for (cell[1] = first[1] - reach_[1]; cell[1] < first[1] + columns_per_tile_[1] + reach_[1]; ++cell[1]) {
                for (cell[0] = first[0] - reach_[0]; cell[0] < first[0] + columns_per_tile_[0] + reach_[0]; ++cell[0]) {
                    const Seen seen = seen_from(first, cell, range_);
                    const std::int32_t of_all = column_of_all(place_of(seen.wrapped));
                    const bool own = own_columns_.first <= of_all && of_all < own_columns_.last;
                    if (seen.side <= 0 || !seen.in_range || own) {
                        continue;
                    }
                    HaloPart& part =
                        of_ranks.try_emplace(rank_of(of_all), HaloPart{rank_of(of_all), 0, 0.0, 0}).first->second;
                    add_column(part, area, above - range_, above + height_ + range_, height_);
                }
            }
        }
    }
    std::vector<HaloPart> parts;
    parts.reserve(of_ranks.size());
    for (const auto& [rank, part] : of_ranks) {
        parts.push_back(part);
    }
    return parts;
}

double ClusterGrid::own_volume() const {
    return own_column_count() * height_ / (inverse_width_[0] * inverse_width_[1]);
}

void ClusterGrid::send_to_owners(State& state, State* companion) const {
    const auto r = std::as_const(state).positions();
    std::vector<int> destinations(static_cast<std::size_t>(state.count()));
    for_each_index(state.execution(), state.count(), [&](Index i) {
        destinations[static_cast<std::size_t>(i)] = rank_of(column_of_all(place_of(cell_at(r.col(i)))));
    });
    state.migrate(destinations);
    if (companion != nullptr) {
        companion->migrate(destinations);
    }
}

void ClusterGrid::fetch_halo(State& state) {
    Ranks& ranks = state.execution().ranks();
    const auto size = static_cast<std::size_t>(ranks.size());
    // Ask for columns, by their numbers at the rank that has them.
    std::vector<std::vector<WantedColumn>> wanted(size);
    for (std::size_t k = 0; k < halo_columns_.size(); ++k) {
        const auto rank = static_cast<std::size_t>(rank_of(halo_columns_[k]));
        wanted[rank].push_back({halo_columns_[k] - first_columns_[rank], halo_heights_[k]});
    }
    std::vector<Ranks::Bytes> requests;
    requests.reserve(size);
    for (const std::vector<WantedColumn>& columns : wanted) {
        requests.push_back(message_of(columns));
    }
    const std::vector<Ranks::Bytes> asked = ranks.exchange(std::move(requests));

    halo_.clear();
    clusters_below_halo_.clear();
    const auto r = std::as_const(state).positions();
    std::vector<Ranks::Bytes> answers;
    for (std::size_t rank = 0; rank < size; ++rank) {
        std::vector<GivenColumn> given;
        std::vector<AtomRange> atoms;
        for (const WantedColumn& column : values_of<WantedColumn>(asked[rank])) {
            const auto k = static_cast<std::size_t>(column.column);
            const double floor = cell_of(column.column)[2] * height_;
            AtomRange part{column_atoms_[k], column_atoms_[k + 1]};
            // Whole clusters, from both ends.
            while (part.count() > slots && r(2, part.first + slots - 1) < floor + column.heights.low) {
                part.first += slots;
            }
            const Index before = part.first - column_atoms_[k];
            Index last_cluster = part.first + (std::max<Index>(part.count(), 1) - 1) / slots * slots;
            while (last_cluster > part.first && r(2, last_cluster) > floor + column.heights.high) {
                part.last = last_cluster;
                last_cluster -= slots;
            }
            atoms.push_back(part);
            given.push_back({static_cast<std::uint32_t>(part.count()), static_cast<std::int32_t>(before / slots)});
        }
        halo_.send(static_cast<int>(rank), std::move(atoms));
        answers.push_back(message_of(given));
    }
    const std::vector<Ranks::Bytes> answered = ranks.exchange(std::move(answers));
    for (std::size_t rank = 0; rank < size; ++rank) {
        const std::uint32_t before = column_atoms_.back();
        for (const GivenColumn& given : values_of<GivenColumn>(answered[rank])) {
            column_atoms_.push_back(column_atoms_.back() + given.atoms);
            clusters_below_halo_.push_back(given.clusters_below);
        }
        halo_.receive(static_cast<int>(rank), column_atoms_.back() - before);
    }
    state.set_ghost_count(halo_.count());
    halo_.refresh(state);
}

ClusterGrid::Abroad ClusterGrid::abroad(std::int32_t cluster) const {
    const auto after = std::upper_bound(column_clusters_.begin(), column_clusters_.end(), cluster);
    const auto column = static_cast<std::int32_t>(after - column_clusters_.begin()) - 1;
    const auto k = static_cast<std::size_t>(column - own_column_count());
    const std::int32_t of_all = halo_columns_[k];
    const int rank = rank_of(of_all);
    return {rank, of_all - first_columns_[static_cast<std::size_t>(rank)],
            cluster - column_clusters_[static_cast<std::size_t>(column)] + clusters_below_halo_[k]};
}

}  // namespace ljmd
