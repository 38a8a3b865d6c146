#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Sorts atoms into columns, and the atoms of a column by z, then by id. All threads of the state take part; the order
/// does not depend on their number. The memory that this takes is kept for the next time, because fresh memory would
/// cost more than the sort.
class ColumnSort {
  public:
    /// Sets column[i] to the column of each atom i of [first, last).
    using FindColumns = std::function<void(Index first, Index last, std::uint32_t* column)>;

    /// @param columns  number of columns, >= 1  @param find  called by all threads; columns are in [0, columns)
    void sort(const State& atoms, std::size_t columns, const FindColumns& find);

    /// Of the last sort(): atom k of the new order is atom order()[k] of the old one.
    [[nodiscard]] const std::vector<Index>& order() const { return order_; }
    /// Of the last sort(): first atom of each column in the new order, followed by the number of atoms.
    [[nodiscard]] const std::vector<std::uint32_t>& first_atoms() const { return first_atoms_; }

  private:
    void sort_column(const State& atoms, std::size_t column);

    std::vector<std::uint32_t> column_;  ///< of each atom
    std::vector<std::uint32_t> next_;    ///< of each share of the atoms and each column: next place in the order
    std::vector<std::uint32_t> first_atoms_;
    std::vector<Index> order_;
};

}  // namespace ljmd
