#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ljmd/core/threads.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/neighbors/pair_visit.hpp"

namespace ljmd {

/// Atoms in clusters of four that are neighbours in space, so that kernels load a cluster as it lies in memory, x after
/// x, instead of collecting its atoms one by one.
///
/// The box is cut into tiles of some thousand atoms, a tile into columns along z, and the atoms of a column, in
/// ascending z, into clusters; a column's last one may have fewer atoms than slots. Atoms are kept in this order: tile
/// by tile, column by column. Clusters are numbered in it, and behind those of the atoms come the periodic images that
/// lie within `range` of the box.
///
/// Tiles are what threads share: sums within a tile are one thread's. They depend on box and number of atoms alone.
/// Source: Pall and Hess (2013), Comput. Phys. Commun. 184, 2641, doi:10.1016/j.cpc.2013.06.003, for clusters;
/// here single atoms meet clusters, which wastes fewer lanes when the range is short.
class ClusterGrid {
  public:
    /// Places for atoms in a cluster.
    static constexpr int slots = 4;

    /// Fix tiles and columns. @pre range > 0
    void configure(const Box& box, double range, Index atoms);

    /// Wrap the atoms into the box, bring them into order, and find their clusters and the images.
    /// The order depends on positions and, of equal ones, ids alone. Ghosts of the state are dropped.
    /// @pre configured for the box and number of atoms of this state
    /// @throws InputError when there are more clusters and images than can be counted
    void sort(State& state);

    /// Clusters of atoms, images left out.
    [[nodiscard]] Index cluster_count() const { return static_cast<Index>(first_atoms_.size()) - 1; }
    [[nodiscard]] Index with_images() const { return cluster_count() + image_count_; }

    /// Consecutive clusters or slots.
    struct Run {
        std::int32_t first;
        std::int32_t last;
        [[nodiscard]] std::int32_t length() const { return last - first; }
    };

    /// Clusters of each tile. Some may have none.
    [[nodiscard]] std::span<const Run> tiles() const { return tiles_; }

    [[nodiscard]] AtomRange atoms_of_tile(Index tile) const {
        const Run& clusters = tiles_[static_cast<std::size_t>(tile)];
        return {first_atoms_[static_cast<std::size_t>(clusters.first)],
                first_atoms_[static_cast<std::size_t>(clusters.last)]};
    }

    /// The first atom of each cluster, and the number of atoms behind the last.
    [[nodiscard]] std::span<const std::uint32_t> first_atoms() const { return first_atoms_; }

    /// Atoms of the cluster, or of the one that it is the image of, and how far away they lie.
    struct Members {
        Index first;
        int count;
        Vec3 shift;  ///< whole edges [sigma]
    };
    [[nodiscard]] Members members(Index cluster) const;

    /// Consecutive clusters that have images next to each other.
    struct Images {
        Run of;
        Index first;  ///< cluster number of the first image
        Vec3 shift;
    };
    /// visit(Images) for all of them, by all threads.
    template <class Visit>
    void for_each_images(Visit&& visit) const {
        for_each_block(static_cast<Index>(images_.size()), images_per_block, [&](Index begin, Index end) {
            for (auto n = static_cast<std::size_t>(begin); n < static_cast<std::size_t>(end); ++n) {
                visit(images_[n]);
            }
        });
    }

    /// Call, by all threads, atom(cluster, k, i, shift) for each slot k of all clusters and images that atom i has,
    /// shifted by whole edges, and empty(cluster, k) for those that none has.
    template <class Atom, class Empty>
    void for_each_slot(Atom&& atom, Empty&& empty) const;

    /// A column of the box, or an image of one in its halo.
    struct Column {
        Run run;              ///< clusters in the box
        std::int32_t offset;  ///< from their numbers to the images', 0 in the box
        double floor;         ///< lowest z [sigma]
        std::size_t slices;   ///< where its slices begin
        bool in_box;
    };
    /// One that may have atoms within range of those of another.
    struct Near {
        Column column;
        double reach;  ///< along z, beyond which nothing is within range [sigma]
        bool once;     ///< in the same tile: pairs are to be counted from one side
    };
    /// Columns of a tile.
    [[nodiscard]] Run columns(std::size_t tile) const;
    [[nodiscard]] Run clusters_of_column(std::int32_t column) const;
    /// All columns near one, itself included; of its tile, only those that do not come before it.
    void find_near(std::int32_t column, std::vector<Near>& near) const;

    /// Lowest and highest z of the atoms of a cluster in the box [sigma].
    struct Extent {
        double low;
        double high;
    };
    [[nodiscard]] const Extent& extent(Index cluster) const { return extents_[static_cast<std::size_t>(cluster)]; }

    /// False when nothing of a column is within range of a cluster.
    [[nodiscard]] bool may_reach(const Near& near, const Extent& extent) const {
        const double floor = near.column.floor;
        return extent.low - range_ <= floor + height_ && extent.high + range_ >= floor;
    }
    /// Clusters of a column that may have atoms within range of those of a cluster; the first is number
    /// run.first + offset, and so on.
    [[nodiscard]] Run window(const Near& near, const Extent& extent) const {
        const auto& [run, offset, floor, slices, in_box] = near.column;
        const std::int32_t* bounds = slices_.data() + slices;
        return {std::max(run.first, bounds[2 * slice(extent.low - near.reach - floor)]),
                std::min(run.last, bounds[2 * slice(extent.high + near.reach - floor) + 1])};
    }

  private:
    using Cell = std::array<int, 3>;
    static constexpr Index images_per_block = 16;

    [[nodiscard]] std::int32_t column_at(const Cell& cell) const;
    [[nodiscard]] Cell cell_of(std::int32_t column) const;
    [[nodiscard]] Cell cell_at(const Vec3& position) const;
    [[nodiscard]] int cells_with_halo(std::size_t axis) const { return cells_[axis] + 2 * reach_[axis]; }
    [[nodiscard]] std::size_t with_halo(const Cell& cell) const;
    /// 0 below the column, slice_count_ + 1 above it. @param above  its lowest z
    [[nodiscard]] Index slice(double above) const {
        return std::clamp(static_cast<int>(above * inverse_slice_ + 1.0), 0, slice_count_ + 1);
    }
    void cut_into_slices();
    void put_in_order(State& state);
    void make_clusters(const State& state);
    void make_images(const Box& box);

    double range_ = 0.0;
    Cell tiles_along_{1, 1, 1};
    Cell columns_per_tile_{1, 1, 1};
    Cell cells_{1, 1, 1};  ///< columns along each axis
    Cell reach_{};         ///< columns to look to each side
    double height_ = 0.0;  ///< of the columns [sigma]
    Vec3 inverse_width_ = Vec3::Zero();
    std::vector<std::uint32_t> column_atoms_;    ///< first atom of each column, and one more
    std::vector<std::int32_t> column_clusters_;  ///< first cluster of each column, and one more
    std::vector<std::uint32_t> first_atoms_{0};  ///< of each cluster, and one more
    std::vector<Extent> extents_;                ///< of each cluster
    int slice_count_ = 1;                        ///< of a column
    double inverse_slice_ = 1.0;
    /// Of each column and slice: the first cluster that reaches up to the slice, and the first that begins above it.
    std::vector<std::int32_t> slices_;
    std::vector<Run> tiles_;
    std::vector<Images> images_;
    std::vector<std::uint32_t> images_of_;  ///< of each image: which of images_ it is among
    std::vector<Column> extended_;          ///< of the box and its halo
    Index image_count_ = 0;
};

template <class Atom, class Empty>
void ClusterGrid::for_each_slot(Atom&& atom, Empty&& empty) const {
    const auto visit = [&](Index cluster, Index owner, const Vec3& shift) {
        const auto first = Index{first_atoms_[static_cast<std::size_t>(owner)]};
        const auto count = static_cast<int>(first_atoms_[static_cast<std::size_t>(owner) + 1] - first);
        for (int k = 0; k < count; ++k) {
            atom(cluster, k, first + k, shift);
        }
        for (int k = count; k < slots; ++k) {
            empty(cluster, k);
        }
    };
    for_each_index(cluster_count(), [&](Index cluster) { visit(cluster, cluster, Vec3::Zero()); });
    for_each_images([&](const Images& images) {
        for (std::int32_t k = 0; k < images.of.length(); ++k) {
            visit(images.first + k, images.of.first + k, images.shift);
        }
    });
}

}  // namespace ljmd
