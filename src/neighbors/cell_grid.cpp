#include "ljmd/neighbors/cell_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Cells a little wider than they must be, so that the rounding in `position * inverse_width` cannot move a neighbour
/// out of reach.
constexpr double safety = 1.0 + 0x1p-40;

/// Cells of half the range are tested 1.7 times less often in vain than cells of the whole range.
constexpr double cells_per_range = 2.0;

/// More cells than this for each atom cost more memory than they save tests.
constexpr double most_cells_per_atom = 4.0;

}  // namespace

void CellGrid::configure(const Box& box, double range, Index atoms) {
    const Vec3 fitting = box.edges() * (cells_per_range / (range * safety));
    const double most_cells = most_cells_per_atom * static_cast<double>(std::max<Index>(atoms, 1));
    const double coarser = std::max(1.0, std::cbrt(fitting.cwiseMax(1.0).prod() / most_cells));
    for (int a = 0; a < 3; ++a) {
        const auto k = static_cast<std::size_t>(a);
        inner_[k] = static_cast<int>(std::max(1.0, std::floor(fitting[a] / coarser)));
        inverse_width_[a] = inner_[k] / box.edges()[a];
        reach_[k] = static_cast<int>(std::ceil(range * safety * inverse_width_[a]));
    }
}

CellGrid::Cell CellGrid::cell_of(const Vec3& position) const {
    Cell cell{};
    for (int a = 0; a < 3; ++a) {
        const auto k = static_cast<std::size_t>(a);
        const int n = static_cast<int>(std::floor(position[a] * inverse_width_[a]));
        cell[k] = std::clamp(n, 0, inner_[k] - 1) + reach_[k];
    }
    return cell;
}

CellGrid::Cell CellGrid::clamped_cell_of(const Vec3& position) const {
    Cell cell{};
    for (int a = 0; a < 3; ++a) {
        const auto k = static_cast<std::size_t>(a);
        const int n = static_cast<int>(std::floor(position[a] * inverse_width_[a])) + reach_[k];
        cell[k] = std::clamp(n, 0, inner_[k] + 2 * reach_[k] - 1);
    }
    return cell;
}

std::size_t CellGrid::flat(const Cell& cell) const {
    const auto width = [this](std::size_t k) {
        return static_cast<std::size_t>(inner_[k]) + 2 * static_cast<std::size_t>(reach_[k]);
    };
    return (static_cast<std::size_t>(cell[2]) * width(1) + static_cast<std::size_t>(cell[1])) * width(0) +
           static_cast<std::size_t>(cell[0]);
}

std::vector<Index> CellGrid::spatial_order(const State& state) const {
    const auto r = state.positions();
    std::vector<std::size_t> cell(static_cast<std::size_t>(state.count()));
    for (std::size_t i = 0; i < cell.size(); ++i) {
        cell[i] = flat(cell_of(r.col(static_cast<Index>(i))));
    }
    std::vector<Index> order(cell.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index i, Index j) {
        const auto a = static_cast<std::size_t>(i);
        const auto b = static_cast<std::size_t>(j);
        return cell[a] != cell[b] ? cell[a] < cell[b] : state.ids()[a] < state.ids()[b];
    });
    return order;
}

void CellGrid::fill(const ConstVectorView& points) {
    if (points.cols() > std::numeric_limits<std::int32_t>::max()) {
        throw InputError(fmt::format("{} atoms and images are more than one process can hold", points.cols()));
    }
    std::size_t cells = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        cells *= static_cast<std::size_t>(inner_[k]) + 2 * static_cast<std::size_t>(reach_[k]);
    }
    // Counting sort: starts_[c + 1] counts, then sums, then serves as the next free place of cell c.
    starts_.assign(cells + 1, 0);
    std::vector<std::size_t> cell(static_cast<std::size_t>(points.cols()));
    for (std::size_t i = 0; i < cell.size(); ++i) {
        cell[i] = flat(clamped_cell_of(points.col(static_cast<Index>(i))));
        ++starts_[cell[i] + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    entries_.resize(cell.size());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < cell.size(); ++i) {
        const auto r = points.col(static_cast<Index>(i));
        entries_[next[cell[i]]++] = {r[0], r[1], r[2], static_cast<std::int32_t>(i)};
    }
}

}  // namespace ljmd
