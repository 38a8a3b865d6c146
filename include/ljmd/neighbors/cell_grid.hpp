#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/domain/ghost_exchange.hpp"
#include "ljmd/model/state.hpp"

namespace ljmd {

/// Linked cells: atoms sorted into a grid of cells over the box and a halo around it, so that all points within
/// `range` of an atom are found in a fixed number of cells, whatever the number of atoms.
///
/// Cells are about range/2 wide, and the edges of the box are a whole number of them; the halo is as many layers of
/// cells as cover `range`. Each of its cells is the image of one in the box and holds the ghosts of that one's atoms.
/// Rows of cells along x lie one after the other in memory, so the neighbourhood of a cell is one contiguous run of
/// points a row; of each row only the part that can lie within `range` of the cell belongs to it.
class CellGrid {
  public:
    /// Fix the cells for a box, a range and a number of atoms (a nearly empty box gets larger cells, so that memory
    /// stays in proportion to the atoms). @pre range > 0
    void configure(const Box& box, double range, Index atoms);

    /// Sort atoms and ghosts into the cells: atoms are wrapped into the box and reordered by cell, and by id within a
    /// cell (the order that results rest on); their images in the halo become the ghosts.
    /// @pre configured for the box and number of atoms of this state
    /// @throws InputError when there are more points than can be counted
    void sort(State& state, GhostExchange& ghosts);

    /// Atoms and ghosts, by their index, in the order of the cells.
    [[nodiscard]] std::span<const std::int32_t> order() const { return order_; }

    /// Places [first, last) in order().
    struct Run {
        std::int32_t first;
        std::int32_t last;
        [[nodiscard]] std::int32_t length() const { return last - first; }
    };

    /// Number of the cell that holds a position. @param position  in [0, L)
    [[nodiscard]] std::size_t cell_at(const Vec3& position) const { return flat(cell_of(position)); }

    /// Call visit(run) for runs that together hold every point within range of the positions of a cell, each once.
    template <class Visit>
    void for_each_run(std::size_t cell, Visit&& visit) const {
        for (const Row& row : rows_) {
            const std::size_t middle =
                cell + static_cast<std::size_t>(row.shift);  // modulo 2^64: shifts may be negative
            visit(Run{static_cast<std::int32_t>(starts_[middle - row.reach]),
                      static_cast<std::int32_t>(starts_[middle + row.reach + 1])});
        }
    }

    /// Runs of every cell.
    [[nodiscard]] std::size_t run_count() const { return rows_.size(); }

  private:
    using Cell = std::array<int, 3>;

    /// The cell of a position in the box, halo layers included in the count.
    [[nodiscard]] Cell cell_of(const Vec3& position) const;
    [[nodiscard]] std::size_t flat(const Cell& cell) const;
    [[nodiscard]] std::size_t cell_count() const;

    /// Order of the atoms by cell and id; starts_ become those of the cells in the box.
    [[nodiscard]] std::vector<Index> spatial_order(const State& state);
    /// Places for the atoms, once they are in spatial order, and for their images in the halo: starts_ and order_
    /// become those of all cells. @return the images
    [[nodiscard]] std::vector<GhostExchange::Run> place_atoms_and_images(const State& state);

    /// Halo included.
    [[nodiscard]] int cells_along(std::size_t axis) const { return inner_[axis] + 2 * reach_[axis]; }
    [[nodiscard]] std::size_t row_length() const { return static_cast<std::size_t>(cells_along(0)); }
    [[nodiscard]] std::size_t layer() const { return row_length() * static_cast<std::size_t>(cells_along(1)); }
    void find_rows(double range);

    /// The part of a row that belongs to the neighbourhood of a cell.
    struct Row {
        std::ptrdiff_t shift;  ///< from the cell to the one in this row with the same x
        std::size_t reach;     ///< cells to each side of that one
    };

    Vec3 inverse_width_ = Vec3::Zero();
    Cell inner_{};  ///< cells along each edge of the box
    Cell reach_{};  ///< cells to look to each side, and layers of the halo
    std::vector<Row> rows_;
    std::vector<std::uint32_t> starts_;
    std::vector<std::int32_t> order_;
};

}  // namespace ljmd
