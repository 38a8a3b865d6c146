#include "neighbors/cluster_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

namespace {

/// Ranges are a little wider than necessary, so that rounding cannot move a neighbour out of reach.
constexpr double safety = 1.0 + 0x1p-36;

/// Positions, forces and lists of a tile should fit into the caches next to a core. A small tile has many ghost
/// clusters for its own ones, which cost copies and a second sum. A small system still gets two tiles, so that two
/// threads can share it.
constexpr double max_atoms_per_tile = 4000.0;
constexpr double min_tiles = 2.0;
constexpr double min_atoms_per_tile = 200.0;

/// Width of a column relative to the edge of a cubic cluster.
constexpr double slimness = 0.93;

/// Slices of a column for each cluster that it has on average.
constexpr double slices_per_cluster = 2.0;

/// Atoms are counted with 32 bits.
constexpr Index max_atoms = Index{1} << 30;

int floor_of(double x) {
    return static_cast<int>(std::floor(x));
}

int rounded(double x) {
    return std::max(1, static_cast<int>(std::lround(x)));
}

/// Number of columns to each side that may be within range, for a number of columns along an edge.
int columns_to_look(int columns, double edge, double range) {
    return static_cast<int>(std::ceil(range * columns / edge));
}

/// Number of columns along an edge of a tile: slim columns, unless these need a wider search than cubic clusters would.
int columns_along(double edge, double cube, double range) {
    const int cubes = rounded(edge / cube);
    int columns = rounded(edge / (slimness * cube));
    while (columns > cubes && columns_to_look(columns, edge, range) > columns_to_look(cubes, edge, range)) {
        --columns;
    }
    return columns;
}

}  // namespace

void ClusterGrid::configure(const Box& box, double range, Index atoms, std::optional<Index> tile, double halo,
                            const Ranks& ranks) {
    range_ = range * safety;
    const double count = std::max(1.0, static_cast<double>(atoms));
    const double atoms_per_tile =
        tile ? static_cast<double>(*tile) : std::clamp(count / min_tiles, min_atoms_per_tile, max_atoms_per_tile);
    const double density = count / box.volume();
    // Cut the longest edge of the tiles until they are small enough.
    tiles_along_ = {1, 1, 1};
    while (count / (tiles_along_[0] * tiles_along_[1] * tiles_along_[2]) > 1.2 * atoms_per_tile) {
        std::size_t longest = 0;
        for (std::size_t a = 1; a < 3; ++a) {
            if (box.edges()[static_cast<Index>(a)] / tiles_along_[a] >
                1.001 * box.edges()[static_cast<Index>(longest)] / tiles_along_[longest]) {
                longest = a;
            }
        }
        ++tiles_along_[longest];
    }
    const double cube = cube_root(slots / density);  // edge of a cubic cluster
    for (std::size_t a = 0; a < 3; ++a) {
        const double edge = box.edges()[static_cast<Index>(a)];
        const double edge_of_tile = edge / tiles_along_[a];
        columns_per_tile_[a] = a == 2 ? 1 : columns_along(edge_of_tile, cube, range_);
        reach_[a] = columns_to_look(columns_per_tile_[a], edge_of_tile, range_);
        cells_[a] = tiles_along_[a] * columns_per_tile_[a];
        inverse_width_[static_cast<Index>(a)] = cells_[a] / edge;
    }
    columns_within_reach_.clear();
    for (int dy = -reach_[1]; dy <= reach_[1]; ++dy) {
        for (int dx = -reach_[0]; dx <= reach_[0]; ++dx) {
            const double left2 = range_ * range_ - gap2(dx, 0) - gap2(dy, 1);
            if (left2 >= 0.0) {
                columns_within_reach_.push_back({dx, dy, std::sqrt(left2)});
            }
        }
    }
    edges_ = box.edges();
    height_ = edges_[2] / cells_[2];
    slice_count_ = rounded(slices_per_cluster * height_ / cube);
    inverse_slice_ = slice_count_ / height_;
    Place step{1, 1};  // from one tile to the next along this axis, and from one column to the next within it
    for (std::size_t a = 0; a < 3; ++a) {
        places_along_[a].clear();
        for (int cell = 0; cell < cells_[a]; ++cell) {
            places_along_[a].push_back(
                {cell / columns_per_tile_[a] * step.tile, cell % columns_per_tile_[a] * step.within});
        }
        step = {step.tile * tiles_along_[a], step.within * columns_per_tile_[a]};
    }
    tile_numbers_.assign(static_cast<std::size_t>(step.tile), 0);
    tile_cells_.clear();
    number_tiles({0, 0, 0}, tiles_along_);
    share_tiles(ranks, halo * safety);
}

void ClusterGrid::number_tiles(const Cell& first, const Cell& last) {
    std::size_t longest = 0;
    double length = 0.0;
    for (const std::size_t a : {2U, 1U, 0U}) {
        const int tiles = last[a] - first[a];
        const double along = tiles > 1 ? tiles * edges_[static_cast<Index>(a)] / tiles_along_[a] : 0.0;
        if (along > 1.001 * length) {
            longest = a;
            length = along;
        }
    }
    if (length == 0.0) {  // one tile
        const auto [x, y, z] = first;
        const Index place = (Index{z} * tiles_along_[1] + y) * tiles_along_[0] + x;
        tile_numbers_[static_cast<std::size_t>(place)] = static_cast<std::int32_t>(tile_cells_.size());
        tile_cells_.push_back(first);
        return;
    }
    const int middle = (first[longest] + last[longest]) / 2;
    Cell last_of_lower = last;
    Cell first_of_upper = first;
    last_of_lower[longest] = first_of_upper[longest] = middle;
    number_tiles(first, last_of_lower);
    number_tiles(first_of_upper, last);
}

ClusterGrid::Cell ClusterGrid::cell_of(std::int32_t column) const {
    const int per_tile = columns_per_tile();
    const std::int32_t own = own_column_count();
    const std::int32_t of_all =
        column < own ? own_columns_.first + column : halo_columns_[static_cast<std::size_t>(column - own)];
    Cell cell = tile_cells_[static_cast<std::size_t>(of_all / per_tile)];
    int within = of_all % per_tile;
    for (std::size_t a = 0; a < 3; ++a) {
        cell[a] = cell[a] * columns_per_tile_[a] + within % columns_per_tile_[a];
        within /= columns_per_tile_[a];
    }
    return cell;
}

ClusterGrid::Cell ClusterGrid::cell_at(const Vec3& position) const {
    Cell cell{};
    for (std::size_t a = 0; a < 3; ++a) {
        const auto k = static_cast<Index>(a);
        cell[a] = std::clamp(static_cast<int>(position[k] * inverse_width_[k]), 0, cells_[a] - 1);
    }
    return cell;
}

int ClusterGrid::boxes_away(int cell, std::size_t axis) const {
    return floor_of(static_cast<double>(cell) / cells_[axis]);
}

ClusterGrid::Run ClusterGrid::columns(std::size_t tile) const {
    const auto first = static_cast<std::int32_t>(tile) * columns_per_tile();
    return {first, first + columns_per_tile()};
}

ClusterGrid::Run ClusterGrid::clusters_of_column(std::int32_t column) const {
    const auto k = static_cast<std::size_t>(column);
    return {column_clusters_[k], column_clusters_[k + 1]};
}

void ClusterGrid::sort(State& state, State* companion) {
    if (state.count() > max_atoms) {
        throw InputError(fmt::format("{} atoms are more than one process can hold", state.count()));
    }
    state.wrap();
    const bool alone = state.execution().ranks().alone();
    if (!alone) {
        send_to_owners(state, companion);
    }
    put_in_order(state, companion);
    if (!alone) {
        fetch_halo(state);
    }
    make_clusters(state);
}

void ClusterGrid::put_in_order(State& state, State* companion) {
    const auto r = static_cast<const State&>(state).positions();
    sort_.sort(state, static_cast<std::size_t>(own_column_count()),
               [&](Index first, Index last, std::uint32_t* column) {
                   for (Index i = first; i < last; ++i) {
                       column[i] = static_cast<std::uint32_t>(column_at(cell_at(r.col(i))));
                   }
               });
    column_atoms_ = sort_.first_atoms();
    state.reorder(sort_.order());
    if (companion != nullptr) {
        companion->reorder(sort_.order());
    }
}

void ClusterGrid::make_clusters(const State& state) {
    const auto r = state.positions_and_ghosts();
    const std::size_t all_columns = column_atoms_.size() - 1;
    const auto slots_of_cluster = static_cast<std::uint32_t>(slots);
    column_clusters_.resize(all_columns + 1);
    column_clusters_[0] = 0;
    for (std::size_t c = 0; c < all_columns; ++c) {
        const std::uint32_t atoms = column_atoms_[c + 1] - column_atoms_[c];
        column_clusters_[c + 1] =
            column_clusters_[c] + static_cast<std::int32_t>((atoms + slots_of_cluster - 1) / slots_of_cluster);
    }
    const auto clusters = static_cast<std::size_t>(column_clusters_[all_columns]);
    first_atoms_.resize(clusters + 1);
    extents_.resize(clusters);
    first_atoms_[clusters] = column_atoms_[all_columns];
    for_each_block(state.execution(), static_cast<Index>(all_columns), columns_per_block, [&](Index first, Index last) {
        for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c) {
            auto cluster = static_cast<std::size_t>(column_clusters_[c]);
            for (std::uint32_t atom = column_atoms_[c]; atom < column_atoms_[c + 1]; atom += slots_of_cluster) {
                const std::uint32_t highest = std::min(atom + slots_of_cluster, column_atoms_[c + 1]) - 1;
                first_atoms_[cluster] = atom;
                extents_[cluster++] = {r(2, atom), r(2, highest)};
            }
        }
    });

    cut_into_slices(state.execution());
    tiles_.clear();
    for (std::int32_t c = 0; c < own_column_count();) {
        const Run of_tile = columns(tiles_.size());
        tiles_.push_back({clusters_of_column(of_tile.first).first, clusters_of_column(of_tile.last - 1).last});
        c = of_tile.last;
    }
}

void ClusterGrid::cut_into_slices(const Execution& execution) {
    const auto columns = static_cast<Index>(column_clusters_.size()) - 1;
    const auto stride = 2 * static_cast<std::size_t>(slice_count_ + 2);
    slices_.resize(static_cast<std::size_t>(columns) * stride);
    for_each_block(execution, columns, columns_per_block, [&](Index first, Index last) {
        for (Index column = first; column < last; ++column) {
            const auto number = static_cast<std::int32_t>(column);
            const Run run = clusters_of_column(number);
            const double floor = cell_of(number)[2] * height_;
            std::int32_t* slices = slices_.data() + static_cast<std::size_t>(column) * stride;
            std::int32_t reaching = run.first;
            std::int32_t above = run.first;
            for (Index n = 0; n < slice_count_ + 2; ++n) {
                while (reaching < run.last && slice(extent(reaching).high - floor) < n) {
                    ++reaching;
                }
                while (above < run.last && slice(extent(above).low - floor) <= n) {
                    ++above;
                }
                slices[2 * n] = reaching;
                slices[2 * n + 1] = above;
            }
        }
    });
}

/// Squared distance between columns that are `cells` columns apart, between which lies one column less.
double ClusterGrid::gap2(int cells, std::size_t axis) const {
    const double gap = std::max(0, std::abs(cells) - 1) / inverse_width_[static_cast<Index>(axis)];
    return gap * gap;
}

/// Clusters of a column that, shifted, lie at least in part between two heights.
ClusterGrid::Run ClusterGrid::ghosts_of_column(std::int32_t column, double shift, double low, double high) const {
    Run run = clusters_of_column(column);
    while (run.length() > 0 && extent(run.first).high + shift < low) {
        ++run.first;
    }
    while (run.length() > 0 && extent(run.last - 1).low + shift > high) {
        --run.last;
    }
    return run;
}

ClusterGrid::Seen ClusterGrid::seen_from(const Cell& first, const Cell& cell, double range) const {
    Seen seen{{}, Vec3::Zero(), 0, false};
    double left2 = range * range;
    for (std::size_t a = 0; a < 3; ++a) {
        const int boxes = boxes_away(cell[a], a);
        seen.wrapped[a] = cell[a] - boxes * cells_[a];
        seen.shift[static_cast<Index>(a)] = boxes * edges_[static_cast<Index>(a)];
        const int before = std::min(0, cell[a] - first[a]);
        const int behind = std::max(0, cell[a] - first[a] - columns_per_tile_[a] + 1);
        seen.side = before < 0 ? -1 : behind > 0 ? 1 : seen.side;
        left2 -= gap2(before + behind, a);
    }
    seen.in_range = left2 >= 0.0;
    return seen;
}

ClusterGrid::Neighborhood ClusterGrid::neighborhood(std::size_t tile) const {
    Neighborhood around;
    around.own_ = tiles_[tile];
    around.count_ = around.own_.length();
    const Cell first = cell_of(columns(tile).first);
    for (std::size_t a = 0; a < 3; ++a) {
        around.corner_[a] = first[a] - reach_[a];
        around.cells_[a] = columns_per_tile_[a] + 2 * reach_[a];
    }
    const auto [corner, cells] = std::pair(around.corner_, around.cells_);
    Cell cell{};
    for (cell[2] = corner[2]; cell[2] < corner[2] + cells[2]; ++cell[2]) {
        for (cell[1] = corner[1]; cell[1] < corner[1] + cells[1]; ++cell[1]) {
            for (cell[0] = corner[0]; cell[0] < corner[0] + cells[0]; ++cell[0]) {
                const auto [wrapped, shift, side, in_range] = seen_from(first, cell, range_);
                Column column;
                column.column = column_at(wrapped);
                column.floor = cell[2] * height_;
                column.slices = static_cast<std::size_t>(std::max(column.column, 0)) * 2 *
                                static_cast<std::size_t>(slice_count_ + 2);
                column.ghost = side != 0;
                if (side == 0) {
                    column.run = clusters_of_column(column.column);
                    column.offset = -around.own_.first;
                } else if (side > 0 && in_range) {
                    const double floor = first[2] * height_;
                    column.run = ghosts_of_column(column.column, shift[2], floor - range_, floor + height_ + range_);
                    column.offset = around.count_ - column.run.first;
                    if (column.run.length() > 0) {
                        around.ghosts_.push_back({column.run, around.count_, shift});
                        around.count_ += column.run.length();
                    }
                }
                around.columns_.push_back(column);
            }
        }
    }
    return around;
}

void ClusterGrid::find_near(const Neighborhood& neighborhood, std::int32_t column, std::vector<Near>& near) const {
    near.clear();
    const auto& [corner, cells] = std::tie(neighborhood.corner_, neighborhood.cells_);
    const Cell center = cell_of(column);
    for (int dz = -reach_[2]; dz <= reach_[2]; ++dz) {
        for (const auto& [dx, dy, reach] : columns_within_reach_) {
            const Index x = center[0] + dx - corner[0];
            const Index y = center[1] + dy - corner[1];
            const Index z = center[2] + dz - corner[2];
            const Column& other = neighborhood.columns_[static_cast<std::size_t>((z * cells[1] + y) * cells[0] + x)];
            if (other.run.length() > 0 && (other.ghost || other.column >= column)) {
                near.push_back({other, reach});
            }
        }
    }
}

}  // namespace ljmd
