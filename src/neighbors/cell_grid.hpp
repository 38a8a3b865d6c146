#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/model/state.hpp"
#include "neighbors/ghost_exchange.hpp"

namespace ljmd {

/// Linked cells: atoms sorted into a grid of cells over the box and a halo around it. All points within `range` of an
/// atom lie in a fixed number of cells, whatever the number of atoms.
///
/// Cells are about range/2 wide, and a whole number of them fits each edge of the box. The halo has as many layers of
/// cells as cover `range`. Each halo cell is the periodic image of a cell in the box and holds the ghosts of the atoms
/// there. Rows of cells along x lie one after the other in memory, so each row contributes one contiguous run of points
/// to the neighbourhood of a cell. Only the part of a row that can lie within `range` of the cell belongs to the
/// neighbourhood.
class CellGrid {
  public:
    /// Set up the cells for a box, a range and a number of atoms. A nearly empty box gets larger cells, so that memory
    /// stays in proportion to the number of atoms. @pre range > 0
    void configure(const Box& box, double range, Index atoms);

    /// Sort atoms and ghosts into the cells. Atoms are wrapped into the box and reordered by cell, and by id within a
    /// cell, because results depend on their order. Their images in the halo become the ghosts.
    /// @pre configured for the box and number of atoms of this state
    /// @throws InputError when there are more points than can be counted
    void sort(State& state, GhostExchange& ghosts);

    /// Indices of atoms and ghosts, in the order of the cells.
    [[nodiscard]] std::span<const std::int32_t> order() const { return order_; }

    /// A range [first, last) in order().
    struct Run {
        std::int32_t first;
        std::int32_t last;
        [[nodiscard]] std::int32_t length() const { return last - first; }
    };

    /// Number of the cell that holds a position. @param position  in [0, L) [sigma]
    [[nodiscard]] std::size_t cell_at(const Vec3& position) const { return flat(cell_of(position)); }

    /// Call visit(run) for runs that together hold every point within range of the positions in a cell, each point
    /// once.
    template <class Visit>
    void for_each_run(std::size_t cell, Visit&& visit) const {
        for (const Row& row : rows_) {
            const std::size_t middle =
                cell + static_cast<std::size_t>(row.shift);  // modulo 2^64, because shifts may be negative
            visit(Run{static_cast<std::int32_t>(starts_[middle - row.reach]),
                      static_cast<std::int32_t>(starts_[middle + row.reach + 1])});
        }
    }

    /// Number of runs that for_each_run() visits for a cell.
    [[nodiscard]] std::size_t run_count() const { return rows_.size(); }

  private:
    using Cell = std::array<int, 3>;

    /// The cell of a position in the box; the layers of the halo are counted, too.
    [[nodiscard]] Cell cell_of(const Vec3& position) const;
    [[nodiscard]] std::size_t flat(const Cell& cell) const;
    [[nodiscard]] std::size_t cell_count() const;

    /// Order of the atoms by cell and id. Fills starts_ for the cells in the box.
    [[nodiscard]] std::vector<Index> spatial_order(const State& state);
    /// Places the atoms, already in spatial order, and their images in the halo. Fills starts_ and order_ for all
    /// cells. @return the images
    [[nodiscard]] std::vector<GhostExchange::Run> place_atoms_and_images(const State& state);

    /// Number of cells, halo included.
    [[nodiscard]] int cells_along(std::size_t axis) const { return inner_[axis] + 2 * reach_[axis]; }
    [[nodiscard]] std::size_t row_length() const { return static_cast<std::size_t>(cells_along(0)); }
    [[nodiscard]] std::size_t layer() const { return row_length() * static_cast<std::size_t>(cells_along(1)); }
    void find_rows(double range);

    /// The part of a row of cells that belongs to the neighbourhood of a cell.
    struct Row {
        std::ptrdiff_t shift;  ///< from the cell to the one with the same x in this row
        std::size_t reach;     ///< cells to each side of that one
    };

    Vec3 inverse_width_ = Vec3::Zero();
    Cell inner_{};  ///< number of cells along each edge of the box
    Cell reach_{};  ///< cells to search on each side; also layers of the halo
    std::vector<Row> rows_;
    std::vector<std::uint32_t> starts_;
    std::vector<std::int32_t> order_;
};

}  // namespace ljmd
