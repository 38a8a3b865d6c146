#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/pair_visit.hpp"

namespace ljmd {

/// Atoms in clusters of four that are neighbours in space, so that kernels load a cluster as it lies in memory, x after
/// x, instead of collecting its atoms one by one.
///
/// The box is cut into tiles of some thousand atoms, a tile into columns along z, and the atoms of a column, in
/// ascending z, into clusters; a column's last one may have fewer atoms than slots. Atoms are kept in this order: tile
/// by tile, column by column. Clusters are numbered in it.
///
/// Tiles are what threads share: sums within a tile are one thread's. They depend on box and number of atoms alone. Of
/// two tiles, images included, one has those clusters of the other as guests that may be within `range` of its own: the
/// one from which the other lies towards higher z, or at the same height towards higher y, or else towards higher x. So
/// each pair of atoms is in one tile only.
/// Source: Pall and Hess (2013), Comput. Phys. Commun. 184, 2641, doi:10.1016/j.cpc.2013.06.003, for clusters;
/// here single atoms meet clusters, which wastes fewer lanes when the range is short.
class ClusterGrid {
  public:
    /// Places for atoms in a cluster.
    static constexpr int slots = 4;

    /// Fix tiles and columns. @pre range > 0
    void configure(const Box& box, double range, Index atoms);

    /// Wrap the atoms into the box, bring them into order, and find their clusters.
    /// The order depends on positions and, of equal ones, ids alone. Ghosts of the state are dropped.
    /// @pre configured for the box and number of atoms of this state
    /// @throws InputError when there are more atoms than can be counted
    void sort(State& state);

    [[nodiscard]] Index cluster_count() const { return static_cast<Index>(first_atoms_.size()) - 1; }

    /// Consecutive clusters or slots.
    struct Run {
        std::int32_t first;
        std::int32_t last;
        [[nodiscard]] std::int32_t length() const { return last - first; }
    };

    /// Clusters of each tile. Some may have none.
    [[nodiscard]] std::span<const Run> tiles() const { return tiles_; }

    /// The first atom of each cluster, and the number of atoms behind the last.
    [[nodiscard]] std::span<const std::uint32_t> first_atoms() const { return first_atoms_; }

    [[nodiscard]] AtomRange atoms_of(const Run& clusters) const {
        return {first_atoms_[static_cast<std::size_t>(clusters.first)],
                first_atoms_[static_cast<std::size_t>(clusters.last)]};
    }
    [[nodiscard]] AtomRange atoms_of_tile(Index tile) const { return atoms_of(tiles_[static_cast<std::size_t>(tile)]); }
    [[nodiscard]] AtomRange atoms_of_cluster(Index cluster) const {
        const auto c = static_cast<std::size_t>(cluster);
        return {first_atoms_[c], first_atoms_[c + 1]};
    }

    /// Columns of a tile.
    [[nodiscard]] Run columns(std::size_t tile) const;
    /// Columns a block of loops over them, see threads.hpp.
    static constexpr Index columns_per_block = 16;
    /// Of all tiles.
    [[nodiscard]] Index column_count() const { return static_cast<Index>(column_clusters_.size()) - 1; }
    [[nodiscard]] Run clusters_of_column(std::int32_t column) const;

    /// Lowest and highest z of the atoms of a cluster [sigma].
    struct Extent {
        double low;
        double high;
    };
    [[nodiscard]] const Extent& extent(Index cluster) const { return extents_[static_cast<std::size_t>(cluster)]; }

    /// Consecutive clusters of one column, or images of them, that are guests of a tile.
    struct Guests {
        Run of;
        std::int32_t first;  ///< what the first of them is in the tile
        Vec3 shift;          ///< how far away the images lie: whole edges [sigma]
    };
    /// A tile and its guests. In it the tile's own clusters are numbered from 0 on, and the guests behind them.
    class Neighborhood;
    [[nodiscard]] Neighborhood neighborhood(std::size_t tile) const;

    /// A column of a tile or of its guests.
    struct Column {
        Run run{0, 0};            ///< clusters
        std::int32_t offset = 0;  ///< from their numbers to those that they have in the tile
        double floor = 0.0;       ///< lowest z [sigma]
        std::size_t slices = 0;   ///< where its slices begin
        std::int32_t column = 0;
        bool guest = false;
    };
    /// One that may have atoms within range of those of another.
    struct Near {
        Column column;
        double reach;  ///< along z, beyond which nothing is within range [sigma]
    };
    /// All columns that may have atoms within range of one of the tile, itself included; of the tile's own only those
    /// that do not come before it. Layer by layer towards higher z, from that of the tile on: there are no guests
    /// below.
    void find_near(const Neighborhood& neighborhood, std::int32_t column, std::vector<Near>& near) const;

    /// Whether a column, and with it those that follow it in find_near(), lies out of range above a cluster.
    [[nodiscard]] bool is_out_of_reach(const Near& near, const Extent& extent) const {
        return extent.high + range_ < near.column.floor;
    }
    /// Clusters of a column that may have atoms within range of those of a cluster.
    [[nodiscard]] Run window(const Near& near, const Extent& extent) const {
        const Column& column = near.column;
        const std::int32_t* bounds = slices_.data() + column.slices;
        return {std::max(column.run.first, bounds[2 * slice(extent.low - near.reach - column.floor)]),
                std::min(column.run.last, bounds[2 * slice(extent.high + near.reach - column.floor) + 1])};
    }

  private:
    friend class ColumnsAround;
    using Cell = std::array<int, 3>;
    [[nodiscard]] std::int32_t column_at(const Cell& cell) const;
    [[nodiscard]] Cell cell_of(std::int32_t column) const;
    [[nodiscard]] Cell cell_at(const Vec3& position) const;
    /// Of a column along an axis: how many whole boxes away from the box it lies.
    [[nodiscard]] int boxes_away(int cell, std::size_t axis) const;
    /// 0 below the column, slice_count_ + 1 above it. @param above  its lowest z
    [[nodiscard]] Index slice(double above) const {
        return std::clamp(static_cast<int>(above * inverse_slice_ + 1.0), 0, slice_count_ + 1);
    }
    void cut_into_slices();
    void put_in_order(State& state);
    void make_clusters(const State& state);
    [[nodiscard]] double gap2(int cells, std::size_t axis) const;
    [[nodiscard]] Run guests_of_column(std::int32_t column, double shift, double low, double high) const;

    double range_ = 0.0;
    Cell tiles_along_{1, 1, 1};
    Cell columns_per_tile_{1, 1, 1};
    Cell cells_{1, 1, 1};  ///< columns along each axis
    Cell reach_{};         ///< columns to look to each side
    double height_ = 0.0;  ///< of the columns [sigma]
    Vec3 inverse_width_ = Vec3::Zero();
    Vec3 edges_ = Vec3::Zero();
    std::vector<std::uint32_t> column_atoms_;    ///< first atom of each column, and one more
    std::vector<std::int32_t> column_clusters_;  ///< first cluster of each column, and one more
    std::vector<std::uint32_t> first_atoms_{0};  ///< of each cluster, and one more
    std::vector<Extent> extents_;                ///< of each cluster
    int slice_count_ = 1;                        ///< of a column
    double inverse_slice_ = 1.0;
    /// Of each column and slice: the first cluster that reaches up to the slice, and the first that begins above it.
    std::vector<std::int32_t> slices_;
    std::vector<Run> tiles_;
    /// The number of a column is the sum of what its places along x, y and z have here.
    std::array<std::vector<std::int32_t>, 3> numbers_along_;
};

class ClusterGrid::Neighborhood {
  public:
    [[nodiscard]] const Run& own() const { return own_; }
    [[nodiscard]] const std::vector<Guests>& guests() const { return guests_; }
    /// With the guests.
    [[nodiscard]] std::int32_t cluster_count() const { return count_; }

  private:
    friend class ClusterGrid;
    Run own_{0, 0};
    Cell corner_{};  ///< of the columns that follow: the tile's own and all within reach of them
    Cell cells_{};
    std::vector<Column> columns_;  ///< without clusters where nobody is met
    std::vector<Guests> guests_;
    std::int32_t count_ = 0;
};

}  // namespace ljmd
