#include "ljmd/neighbors/cluster_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Ranges a little wider than they must be, so that rounding cannot move a neighbour out of reach.
constexpr double safety = 1.0 + 0x1p-36;

/// A tile's positions, forces and lists should fit into the caches next to a core; pairs across its walls are computed
/// twice, so it should not be small. Few atoms are still shared among several threads.
constexpr double most_atoms_per_tile = 4000.0;
constexpr double fewest_tiles = 2.0;
constexpr double fewest_atoms_per_tile = 200.0;

/// Slices of a column for each cluster that it has on the mean.
constexpr double slices_per_cluster = 2.0;

/// Kernels count numbers of clusters in 32 bits, three a slot.
constexpr Index most_slots = Index{1} << 30;

constexpr Index columns_per_block = 16;

int floor_of(double x) {
    return static_cast<int>(std::floor(x));
}

int rounded(double x) {
    return std::max(1, static_cast<int>(std::lround(x)));
}

}  // namespace

void ClusterGrid::configure(const Box& box, double range, Index atoms) {
    range_ = range * safety;
    const double count = std::max(1.0, static_cast<double>(atoms));
    const double atoms_per_tile = std::clamp(count / fewest_tiles, fewest_atoms_per_tile, most_atoms_per_tile);
    const double density = count / box.volume();
    // Cut the longest edge of the tiles again and again.
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
    const double width = std::cbrt(slots / density);  // of a cluster that is a cube
    for (std::size_t a = 0; a < 3; ++a) {
        const double edge = box.edges()[static_cast<Index>(a)];
        columns_per_tile_[a] = a == 2 ? 1 : rounded(edge / tiles_along_[a] / width);
        cells_[a] = tiles_along_[a] * columns_per_tile_[a];
        inverse_width_[static_cast<Index>(a)] = cells_[a] / edge;
        reach_[a] = static_cast<int>(std::ceil(range_ * inverse_width_[static_cast<Index>(a)]));
    }
    height_ = box.edges()[2] / cells_[2];
    slice_count_ = rounded(slices_per_cluster * height_ / width);
    inverse_slice_ = slice_count_ / height_;
}

std::int32_t ClusterGrid::column_at(const Cell& cell) const {
    std::int32_t tile = 0;
    std::int32_t within = 0;
    for (const std::size_t a : {2U, 1U, 0U}) {
        tile = tile * tiles_along_[a] + cell[a] / columns_per_tile_[a];
        within = within * columns_per_tile_[a] + cell[a] % columns_per_tile_[a];
    }
    return tile * columns_per_tile_[0] * columns_per_tile_[1] + within;
}

ClusterGrid::Cell ClusterGrid::cell_of(std::int32_t column) const {
    const int per_tile = columns_per_tile_[0] * columns_per_tile_[1];
    int tile = column / per_tile;
    int within = column % per_tile;
    Cell cell{};
    for (std::size_t a = 0; a < 3; ++a) {
        cell[a] = tile % tiles_along_[a] * columns_per_tile_[a] + within % columns_per_tile_[a];
        tile /= tiles_along_[a];
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

std::size_t ClusterGrid::with_halo(const Cell& cell) const {
    std::size_t flat = 0;
    for (const std::size_t a : {2U, 1U, 0U}) {
        flat = flat * static_cast<std::size_t>(cells_with_halo(a)) + static_cast<std::size_t>(cell[a] + reach_[a]);
    }
    return flat;
}

ClusterGrid::Run ClusterGrid::columns(std::size_t tile) const {
    const int per_tile = columns_per_tile_[0] * columns_per_tile_[1];
    const auto first = static_cast<std::int32_t>(tile) * per_tile;
    return {first, first + per_tile};
}

ClusterGrid::Run ClusterGrid::clusters_of_column(std::int32_t column) const {
    const auto k = static_cast<std::size_t>(column);
    return {column_clusters_[k], column_clusters_[k + 1]};
}

ClusterGrid::Members ClusterGrid::members(Index cluster) const {
    Index owner = cluster;
    Vec3 shift = Vec3::Zero();
    if (cluster >= cluster_count()) {
        const auto k = static_cast<std::size_t>(cluster - cluster_count());
        const Images& images = images_[images_of_[k]];
        owner = images.of.first + (cluster - images.first);
        shift = images.shift;
    }
    const Index first = first_atoms_[static_cast<std::size_t>(owner)];
    return {first, static_cast<int>(first_atoms_[static_cast<std::size_t>(owner) + 1] - first), shift};
}

void ClusterGrid::sort(State& state) {
    if (state.count() > most_slots) {
        throw InputError(fmt::format("{} atoms are more than one process can hold", state.count()));
    }
    state.wrap();
    put_in_order(state);
    make_clusters(state);
    make_images(state.box());
    if (with_images() * slots > most_slots) {
        throw InputError(fmt::format("{} atoms and images are more than one process can hold", with_images() * slots));
    }
}

void ClusterGrid::put_in_order(State& state) {
    const State& atoms = state;
    const auto r = atoms.positions();
    const auto columns =
        static_cast<std::size_t>(cells_[0]) * static_cast<std::size_t>(cells_[1]) * static_cast<std::size_t>(cells_[2]);
    std::vector<std::uint32_t> column(static_cast<std::size_t>(state.count()));
    for_each_index(state.count(), [&](Index i) {
        column[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(column_at(cell_at(r.col(i))));
    });
    // Counting sort: column_atoms_[c + 1] serves as the next free place of column c and ends as the start of c + 1.
    column_atoms_.assign(columns + 2, 0);
    for (const std::uint32_t c : column) {
        ++column_atoms_[c + 2];
    }
    std::partial_sum(column_atoms_.begin(), column_atoms_.end(), column_atoms_.begin());
    struct Place {
        double z;
        Index id;
        Index atom;
    };
    std::vector<Place> places(column.size());
    for (Index i = 0; i < state.count(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        places[column_atoms_[column[k] + 1]++] = {r(2, i), state.ids()[k], i};
    }
    column_atoms_.pop_back();

    std::vector<Index> order(column.size());
    for_each_block(static_cast<Index>(columns), columns_per_block, [&](Index first, Index last) {
        for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c) {
            const auto begin = places.begin() + column_atoms_[c];
            const auto end = places.begin() + column_atoms_[c + 1];
            std::sort(begin, end,
                      [](const Place& a, const Place& b) { return std::tie(a.z, a.id) < std::tie(b.z, b.id); });
            std::transform(begin, end, order.begin() + column_atoms_[c], [](const Place& place) { return place.atom; });
        }
    });
    state.reorder(order);
}

void ClusterGrid::make_clusters(const State& state) {
    const auto r = state.positions();
    first_atoms_.clear();
    extents_.clear();
    column_clusters_.clear();
    for (std::size_t c = 0; c + 1 < column_atoms_.size(); ++c) {
        column_clusters_.push_back(static_cast<std::int32_t>(first_atoms_.size()));
        for (std::uint32_t first = column_atoms_[c]; first < column_atoms_[c + 1];
             first += static_cast<std::uint32_t>(slots)) {
            const std::uint32_t last = std::min(first + static_cast<std::uint32_t>(slots), column_atoms_[c + 1]) - 1;
            first_atoms_.push_back(first);
            extents_.push_back({r(2, first), r(2, last)});
        }
    }
    column_clusters_.push_back(static_cast<std::int32_t>(first_atoms_.size()));
    first_atoms_.push_back(column_atoms_.back());

    cut_into_slices();
    tiles_.clear();
    for (std::int32_t c = 0; c + 1 < static_cast<std::int32_t>(column_clusters_.size());) {
        const Run of_tile = columns(tiles_.size());
        tiles_.push_back({clusters_of_column(of_tile.first).first, clusters_of_column(of_tile.last - 1).last});
        c = of_tile.last;
    }
}

void ClusterGrid::cut_into_slices() {
    const auto columns = static_cast<Index>(column_clusters_.size()) - 1;
    const auto stride = 2 * static_cast<std::size_t>(slice_count_ + 2);
    slices_.resize(static_cast<std::size_t>(columns) * stride);
    for_each_block(columns, columns_per_block, [&](Index first, Index last) {
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

void ClusterGrid::make_images(const Box& box) {
    images_.clear();
    images_of_.clear();
    image_count_ = 0;
    extended_.clear();
    // How many edges away the image is that a column belongs to; 0 in the box.
    const auto crossings = [&](int cell, std::size_t axis) {
        return floor_of(static_cast<double>(cell) / cells_[axis]);
    };
    for (int z = -reach_[2]; z < cells_[2] + reach_[2]; ++z) {
        for (int y = -reach_[1]; y < cells_[1] + reach_[1]; ++y) {
            for (int x = -reach_[0]; x < cells_[0] + reach_[0]; ++x) {
                const Cell n{crossings(x, 0), crossings(y, 1), crossings(z, 2)};
                const std::int32_t column =
                    column_at({x - n[0] * cells_[0], y - n[1] * cells_[1], z - n[2] * cells_[2]});
                const std::size_t slices =
                    static_cast<std::size_t>(column) * 2 * static_cast<std::size_t>(slice_count_ + 2);
                const double floor = z * height_;
                Run run = clusters_of_column(column);
                const Vec3 shift = Vec3(n[0], n[1], n[2]).cwiseProduct(box.edges());
                if (n == Cell{}) {
                    extended_.push_back({run, 0, floor, slices, true});
                    continue;
                }
                while (run.length() > 0 && extent(run.first).high + shift[2] < -range_) {
                    ++run.first;
                }
                while (run.length() > 0 && extent(run.last - 1).low + shift[2] > box.edges()[2] + range_) {
                    --run.last;
                }
                const auto first = cluster_count() + image_count_;
                extended_.push_back({run, static_cast<std::int32_t>(first) - run.first, floor, slices, false});
                if (run.length() > 0) {
                    images_of_.resize(static_cast<std::size_t>(image_count_ + run.length()),
                                      static_cast<std::uint32_t>(images_.size()));
                    images_.push_back({run, first, shift});
                    image_count_ += run.length();
                }
            }
        }
    }
}

void ClusterGrid::find_near(std::int32_t column, std::vector<Near>& near) const {
    near.clear();
    const Cell center = cell_of(column);
    // Between columns that lie n apart along an axis there are n - 1 whole ones.
    const auto gap2 = [&](int offset, std::size_t axis) {
        const double gap = std::max(0, std::abs(offset) - 1) / inverse_width_[static_cast<Index>(axis)];
        return gap * gap;
    };
    for (int dz = -reach_[2]; dz <= reach_[2]; ++dz) {
        for (int dy = -reach_[1]; dy <= reach_[1]; ++dy) {
            for (int dx = -reach_[0]; dx <= reach_[0]; ++dx) {
                const double left2 = range_ * range_ - gap2(dx, 0) - gap2(dy, 1);
                if (left2 < 0.0) {
                    continue;
                }
                const Cell cell{center[0] + dx, center[1] + dy, center[2] + dz};
                const Column& other = extended_[with_halo(cell)];
                bool same_tile = other.in_box;
                for (std::size_t a = 0; a < 3 && same_tile; ++a) {
                    same_tile = cell[a] / columns_per_tile_[a] == center[a] / columns_per_tile_[a];
                }
                if (other.run.length() > 0 && !(same_tile && column_at(cell) < column)) {
                    near.push_back({other, std::sqrt(left2), same_tile});
                }
            }
        }
    }
}

}  // namespace ljmd
