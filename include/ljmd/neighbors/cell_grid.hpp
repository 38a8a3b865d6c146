#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// Linked cells: points sorted into a grid of cells over the box and a halo around it, so that all points within
/// `range` of an atom are found in a fixed number of cells, whatever the number of atoms.
///
/// The box is cut into whole cells of about range/2; the halo is as many layers of cells as cover `range`. Rows of
/// cells along x lie one after the other in memory, so the neighbourhood of a cell is a few contiguous runs of points.
class CellGrid {
  public:
    /// Fix the cells for a box, a range and a number of atoms (a nearly empty box gets larger cells, so that memory
    /// stays in proportion to the atoms). @pre range > 0
    void configure(const Box& box, double range, Index atoms);

    /// Order of the local atoms by cell, and by id within a cell: the order that results rest on.
    /// @pre atoms in [0, L)
    [[nodiscard]] std::vector<Index> spatial_order(const State& state) const;

    /// Sort local atoms and ghosts into the cells.
    void fill(const ConstVectorView& points);

    /// A point in its cell.
    struct Entry {
        double x, y, z;
        std::int32_t index;  ///< column in the view given to fill()
    };

    /// Call visit(entries) for each contiguous run of points that can lie within range of `position`.
    /// @param position  in [0, L)
    template <class Visit>
    void for_each_run(const Vec3& position, Visit&& visit) const {
        const auto home = cell_of(position);
        for (int dz = -reach_[2]; dz <= reach_[2]; ++dz) {
            for (int dy = -reach_[1]; dy <= reach_[1]; ++dy) {
                const std::size_t row = flat({home[0], home[1] + dy, home[2] + dz});
                const std::size_t first = starts_[row - static_cast<std::size_t>(reach_[0])];
                const std::size_t last = starts_[row + static_cast<std::size_t>(reach_[0]) + 1];
                visit(std::span<const Entry>(entries_.data() + first, last - first));
            }
        }
    }

  private:
    using Cell = std::array<int, 3>;

    /// The cell of a local atom, halo layers included in the count.
    [[nodiscard]] Cell cell_of(const Vec3& position) const;
    /// The cell of any point, moved to the border of the grid when it lies outside.
    [[nodiscard]] Cell clamped_cell_of(const Vec3& position) const;
    [[nodiscard]] std::size_t flat(const Cell& cell) const;

    Vec3 inverse_width_ = Vec3::Zero();
    Cell inner_{};  ///< cells along each edge of the box
    Cell reach_{};  ///< cells to look to each side, and layers of the halo
    std::vector<std::size_t> starts_;
    std::vector<Entry> entries_;
};

}  // namespace ljmd
