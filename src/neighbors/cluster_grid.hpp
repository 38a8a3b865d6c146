#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "execution/ranks.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/execution/execution.hpp"
#include "neighbors/column_sort.hpp"
#include "neighbors/halo.hpp"
#include "neighbors/pair_visit.hpp"

namespace ljmd {

/// Atoms in clusters of four that lie close together, so that kernels load the coordinates of a cluster as one block,
/// four x, four y, four z, and need not gather them atom by atom.
///
/// The box is cut into tiles of some thousand atoms, a tile into columns along z, and the atoms of a column, sorted by
/// z, into clusters. The last cluster of a column may have fewer atoms than slots. Atoms lie in memory in this order,
/// tile by tile and column by column, and clusters are numbered in it.
///
/// Tiles are the parts that threads share; one thread sums a tile. They depend on the box and the number of atoms
/// alone. They are numbered half by half: first all of one half of the box, then all of the other half, and likewise
/// within each half, so that any run of consecutive tiles is compact, and threads that share the tiles in consecutive
/// runs have few neighbours. A tile also holds ghost clusters: clusters of other tiles, or of periodic images, that may
/// be within `range` of its own. Of two tiles only one holds the other's clusters as ghosts: the one from which the
/// other lies towards higher z, or at the same z towards higher y, or else towards higher x. So each pair of atoms
/// belongs to one tile. Source: Pall and Hess (2013), Comput. Phys. Commun. 184, 2641, doi:10.1016/j.cpc.2013.06.003,
/// for clusters. Their clusters meet clusters; here rows of a cluster's atoms meet parts of clusters (RowShape), which
/// leaves fewer lanes unused when the range is short.
class ClusterGrid {
  public:
    /// Number of atoms that a cluster has room for.
    static constexpr int slots = 4;

    /// Set up tiles and columns. Several ranks share the tiles in consecutive runs. @pre range > 0
    /// @param atoms  of all ranks
    /// @param tile   atoms of a tile, at most about; none: as many as fit into the caches next to a core, and few
    /// enough for two tiles, if these have some hundred atoms each
    /// @param halo   how far from its own tiles a rank sees the atoms of others, on the side of their ghost clusters
    /// [sigma], >= range
    void configure(const Box& box, double range, Index atoms, std::optional<Index> tile = std::nullopt,
                   double halo = 0.0, const Ranks& ranks = no_other_ranks());

    /// How much work each tile of all ranks makes, so that configure() gives each rank about as much; it is used if it
    /// has a number for each tile. Empty: as many tiles to each rank. The same at all ranks.
    void set_work(std::vector<std::int64_t> of_tiles) { work_ = std::move(of_tiles); }

    /// Number of the tiles of all ranks.
    [[nodiscard]] Index tiles_of_all() const { return static_cast<Index>(tile_cells_.size()); }

    /// Wrap the atoms into the box, sort them and form their clusters. The order depends on positions alone, and on ids
    /// where positions are equal. Of several ranks each gets the atoms of its tiles, and as ghosts of the state those
    /// of its halo. Other ghosts are dropped.
    /// @param companion  another state with the same atoms in the same order, which gets the new order, too; or null
    /// @pre configured for the box and number of atoms of this state
    /// @throws InputError when there are more atoms than can be counted
    void sort(State& state, State* companion = nullptr);

    /// What concerns another rank: columns, and their volume [sigma^3].
    struct HaloPart {
        int rank;
        Index columns;
        double volume;
        Index cuts;  ///< ends of columns that are cut off between clusters: up to three atoms more than the volume has
    };
    /// What the halo takes from each other rank, by rank. Ranks that give nothing are left out. @pre configured
    [[nodiscard]] std::vector<HaloPart> halo_parts() const;
    /// What of others the tiles here have as ghosts, and so find forces for, by rank. A column counts once for each
    /// tile. @pre configured
    [[nodiscard]] std::vector<HaloPart> force_parts() const;
    /// Volume of the tiles here [sigma^3]. @pre configured
    [[nodiscard]] double own_volume() const;

    /// The copies of atoms of other ranks.
    [[nodiscard]] Halo& halo() { return halo_; }
    [[nodiscard]] const Halo& halo() const { return halo_; }

    // Clusters, columns and tiles are numbered as they are here: the ones of other ranks' tiles in the halo follow the
    // own ones, and tile 0 is the first one of this rank.

    /// Number of the first tile here among the tiles of all ranks.
    [[nodiscard]] Index first_tile() const { return first_tile_; }
    /// Number of tiles along x, y and z, and where among them each tile of all ranks lies.
    [[nodiscard]] const std::array<int, 3>& tiles_along() const { return tiles_along_; }
    [[nodiscard]] std::span<const std::array<int, 3>> tile_places() const { return tile_cells_; }

    /// Place of a cluster of the halo at its own rank.
    struct Abroad {
        int rank;
        std::int32_t column;   ///< number of its column there
        std::int32_t cluster;  ///< number within its column
    };
    [[nodiscard]] bool is_abroad(std::int32_t cluster) const {
        return cluster >= column_clusters_[static_cast<std::size_t>(own_column_count())];
    }
    [[nodiscard]] Abroad abroad(std::int32_t cluster) const;

    [[nodiscard]] Index cluster_count() const { return static_cast<Index>(first_atoms_.size()) - 1; }

    /// A range [first, last) of clusters, columns or slots.
    struct Run {
        std::int32_t first;
        std::int32_t last;
        [[nodiscard]] std::int32_t length() const { return last - first; }
    };

    /// Clusters of each tile. A tile may be empty.
    [[nodiscard]] std::span<const Run> tiles() const { return tiles_; }

    /// First atom of each cluster, followed by the number of atoms.
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
    /// Columns per block of a parallel loop, see for_each_block().
    static constexpr Index columns_per_block = 16;
    /// Columns of the tiles here.
    [[nodiscard]] std::int32_t own_column_count() const { return own_columns_.length(); }
    /// Those and the columns of the halo.
    [[nodiscard]] Index column_count() const { return static_cast<Index>(column_clusters_.size()) - 1; }
    [[nodiscard]] Run clusters_of_column(std::int32_t column) const;

    /// Lowest and highest z of the atoms of a cluster [sigma].
    struct Extent {
        double low;
        double high;
    };
    [[nodiscard]] const Extent& extent(Index cluster) const { return extents_[static_cast<std::size_t>(cluster)]; }

    /// Consecutive clusters of one column, or images of them, that are ghost clusters of a tile.
    struct GhostClusters {
        Run of;              ///< clusters of which these are images or copies
        std::int32_t first;  ///< number of the first one within the tile
        Vec3 shift;          ///< displacement of the images: whole box edges [sigma]
    };
    /// A tile with its ghost clusters. Within it, the tile's own clusters are numbered from 0, followed by the ghosts.
    class Neighborhood;
    [[nodiscard]] Neighborhood neighborhood(std::size_t tile) const;

    /// A column of a tile or of its ghosts.
    struct Column {
        Run run{0, 0};            ///< clusters
        std::int32_t offset = 0;  ///< added to global cluster numbers gives the numbers in the tile
        double floor = 0.0;       ///< lowest z [sigma]
        std::size_t slices = 0;   ///< index of its first slice in slices_
        std::int32_t column = 0;
        bool ghost = false;
    };
    /// A column that may have atoms within range of another column's atoms.
    struct Near {
        Column column;
        double reach;  ///< largest distance along z at which atoms can be within range [sigma]
    };
    /// Find all columns that may have atoms within range of a column of the tile, itself included. Of the tile's own
    /// columns only those that do not come before it are listed. They are listed layer by layer towards higher z, from
    /// the tile's own layer on; there are no ghosts below.
    void find_near(const Neighborhood& neighborhood, std::int32_t column, std::vector<Near>& near) const;

    /// True if a column lies out of range above a cluster. Then so do all columns that follow it in find_near().
    [[nodiscard]] bool is_out_of_reach(const Near& near, const Extent& extent) const {
        return extent.high + range_ < near.column.floor;
    }
    /// Clusters of a column that may have atoms within range of a cluster.
    [[nodiscard]] Run window(const Near& near, const Extent& extent) const {
        const Column& column = near.column;
        const std::int32_t* bounds = slices_.data() + column.slices;
        return {std::max(column.run.first, bounds[2 * slice(extent.low - near.reach - column.floor)]),
                std::min(column.run.last, bounds[2 * slice(extent.high + near.reach - column.floor) + 1])};
    }

  private:
    friend class ColumnsAround;
    using Cell = std::array<int, 3>;
    /// Number the tiles in [first, last), and all that follow, from tile_cells_.size() on.
    void number_tiles(const Cell& first, const Cell& last);
    /// Contribution of a column's place along an axis to the place of its tile in tile_numbers_, and to its number
    /// within the tile.
    struct Place {
        std::int32_t tile;
        std::int32_t within;
        Place operator+(const Place& other) const { return {tile + other.tile, within + other.within}; }
    };
    /// Number of the column among the columns of all ranks.
    [[nodiscard]] std::int32_t column_of_all(const Place& place) const {
        return tile_numbers_[static_cast<std::size_t>(place.tile)] * columns_per_tile() + place.within;
    }
    /// Number of the column here; -1 if neither this rank nor its halo has it.
    [[nodiscard]] std::int32_t column_at(const Place& place) const {
        const std::int32_t column = column_of_all(place);
        return numbers_here_.empty() ? column : numbers_here_[static_cast<std::size_t>(column)];
    }
    [[nodiscard]] std::int32_t columns_per_tile() const { return columns_per_tile_[0] * columns_per_tile_[1]; }
    [[nodiscard]] Place place_of(const Cell& cell) const {
        const auto& [along_x, along_y, along_z] = places_along_;
        return along_x[static_cast<std::size_t>(cell[0])] + along_y[static_cast<std::size_t>(cell[1])] +
               along_z[static_cast<std::size_t>(cell[2])];
    }
    [[nodiscard]] std::int32_t column_at(const Cell& cell) const { return column_at(place_of(cell)); }
    /// The rank of a column, by its number among the columns of all ranks.
    [[nodiscard]] int rank_of(std::int32_t column) const;
    void share_tiles(const Ranks& ranks, double halo);
    void find_halo(double halo);
    /// The part of a column that is wanted, over its lowest z [sigma].
    struct Heights {
        double low;
        double high;
    };
    void add_halo_of_tile(std::int32_t tile, double halo, std::vector<Heights>& near) const;
    void send_to_owners(State& state, State* companion) const;
    void fetch_halo(State& state);
    [[nodiscard]] Cell cell_of(std::int32_t column) const;
    [[nodiscard]] Cell cell_at(const Vec3& position) const;
    /// How many whole boxes a column lies away from the box along an axis.
    [[nodiscard]] int boxes_away(int cell, std::size_t axis) const;
    /// Number of the slice at a height: 0 below the column, slice_count_ + 1 above it. @param above  height over the
    /// lowest z of the column [sigma]
    [[nodiscard]] Index slice(double above) const {
        return std::clamp(static_cast<int>(above * inverse_slice_ + 1.0), 0, slice_count_ + 1);
    }
    void cut_into_slices(const Execution& execution);
    void put_in_order(State& state, State* companion);
    void make_clusters(const State& state);
    [[nodiscard]] double gap2(int cells, std::size_t axis) const;
    /// A column, seen from a tile.
    struct Seen {
        Cell wrapped;  ///< of the column in the box
        Vec3 shift;    ///< from there: whole box edges [sigma]
        int side;      ///< where the column's tile lies, seen from this one: -1, 0 (same tile) or 1
        bool in_range;
    };
    /// @param first  lowest column of the tile  @param cell  of the column, perhaps outside the box
    /// @param range  [sigma]
    [[nodiscard]] Seen seen_from(const Cell& first, const Cell& cell, double range) const;
    [[nodiscard]] Run ghosts_of_column(std::int32_t column, double shift, double low, double high) const;

    double range_ = 0.0;
    Cell tiles_along_{1, 1, 1};
    Cell columns_per_tile_{1, 1, 1};
    Cell cells_{1, 1, 1};  ///< number of columns along each axis
    Cell reach_{};         ///< columns to search on each side
    double height_ = 0.0;  ///< height of a column [sigma]
    Vec3 inverse_width_ = Vec3::Zero();
    Vec3 edges_ = Vec3::Zero();
    /// A place of a column beside another one in the same layer.
    struct Beside {
        int dx;
        int dy;
        double reach;  ///< see Near
    };
    std::vector<Beside> columns_within_reach_;
    ColumnSort sort_;
    std::vector<std::uint32_t> column_atoms_;    ///< first atom of each column, followed by the number of atoms
    std::vector<std::int32_t> column_clusters_;  ///< first cluster of each column, followed by the number of clusters
    std::vector<std::uint32_t> first_atoms_{0};  ///< first atom of each cluster, followed by the number of atoms
    std::vector<Extent> extents_;                ///< extent of each cluster
    int slice_count_ = 1;                        ///< slices of a column
    double inverse_slice_ = 1.0;
    /// For each column and slice: the first cluster that reaches up to the slice, and the first that begins above it.
    std::vector<std::int32_t> slices_;
    std::vector<Run> tiles_;
    Run own_columns_{0, 0};  ///< among the columns of all ranks
    Index first_tile_ = 0;
    std::vector<std::int64_t> work_;
    std::vector<std::int32_t> first_columns_;        ///< of each rank among the columns of all ranks; then the number
                                                     ///< of all
    std::vector<std::int32_t> halo_columns_;         ///< numbers among the columns of all ranks, from the lowest up
    std::vector<Heights> halo_heights_;              ///< of those columns
    std::vector<std::int32_t> clusters_below_halo_;  ///< of those columns: clusters that were not wanted
    struct WantedColumn {
        std::int32_t column;  ///< number at the rank that has it
        Heights heights;
    };
    struct GivenColumn {
        std::uint32_t atoms;
        std::int32_t clusters_below;
    };
    std::vector<std::int32_t> numbers_here_;  ///< by the number among the columns of all ranks; empty without other
                                              ///< ranks
    Halo halo_;
    std::vector<std::int32_t> tile_numbers_;  ///< of the tiles as they lie along x, then y, then z
    std::vector<Cell> tile_cells_;            ///< place of each tile along x, y and z
    /// The place of a column is the sum of the entries for its cell along x, y and z.
    std::array<std::vector<Place>, 3> places_along_;
};

class ClusterGrid::Neighborhood {
  public:
    [[nodiscard]] const Run& own() const { return own_; }
    [[nodiscard]] const std::vector<GhostClusters>& ghosts() const { return ghosts_; }
    /// Number of clusters, ghosts included.
    [[nodiscard]] std::int32_t cluster_count() const { return count_; }

  private:
    friend class ClusterGrid;
    Run own_{0, 0};
    Cell corner_{};  ///< lowest corner of the columns below: the tile's own and all in their reach
    Cell cells_{};
    std::vector<Column> columns_;  ///< empty if they lie on the side where the tile has no ghosts
    std::vector<GhostClusters> ghosts_;
    std::int32_t count_ = 0;
};

}  // namespace ljmd
