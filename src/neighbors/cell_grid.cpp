#include "neighbors/cell_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

namespace {

/// Cells and ranges are a little wider than necessary, so that rounding in `position * inverse_width` cannot move a
/// neighbour out of reach.
constexpr double safety = 1.0 + 0x1p-40;

/// With cells of half the range, 1.7 times fewer distance tests fail than with cells of the whole range.
constexpr double cells_per_range = 2.0;

/// More cells per atom cost more memory than they save tests.
constexpr double max_cells_per_atom = 3.0;

/// Cells and places are counted with 32 bits.
constexpr Index max_points = Index{1} << 30;

/// The largest integer not above x. @pre -2^31 < x < 2^31
int floor_of(double x) {
    const int n = static_cast<int>(x);  // towards zero; std::floor is a function call on processors without SSE4.1
    return n - (n > x ? 1 : 0);
}

/// Counting sort for keys 0 ... bins-1. `starts` gets bins + 1 entries, `order` the indices by key; equal keys keep
/// their order.
void sort_by(const std::vector<std::uint32_t>& keys, std::size_t bins, std::vector<std::uint32_t>& starts,
             std::vector<std::int32_t>& order) {
    starts.assign(bins + 1, 0);
    for (const std::uint32_t key : keys) {
        ++starts[key + 1];
    }
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    order.resize(keys.size());
    // starts[k] serves as the next free place of bin k and ends as the start of bin k + 1.
    for (std::size_t i = 0; i < keys.size(); ++i) {
        order[starts[keys[i]]++] = static_cast<std::int32_t>(i);
    }
    std::copy_backward(starts.begin(), starts.end() - 1, starts.end());
    starts[0] = 0;
}

void require_countable(Index points) {
    if (points > max_points) {
        throw InputError(fmt::format("{} atoms and images are more than one process can hold", points));
    }
}

/// Append first, first + 1, ...
void append_range(std::vector<std::int32_t>& numbers, Index first, Index count) {
    const std::size_t size = numbers.size();
    require_countable(static_cast<Index>(size) + count);
    numbers.resize(size + static_cast<std::size_t>(count));
    std::iota(numbers.begin() + static_cast<Index>(size), numbers.end(), static_cast<std::int32_t>(first));
}

}  // namespace

void CellGrid::configure(const Box& box, double range, Index atoms) {
    const Vec3 fitting = box.edges() * (cells_per_range / (range * safety));
    const double max_cells = max_cells_per_atom * static_cast<double>(std::max<Index>(atoms, 1));
    const double coarser = std::max(1.0, cube_root(fitting.cwiseMax(1.0).prod() / max_cells));
    for (int a = 0; a < 3; ++a) {
        const auto k = static_cast<std::size_t>(a);
        inner_[k] = static_cast<int>(std::max(1.0, std::floor(fitting[a] / coarser)));
        inverse_width_[a] = inner_[k] / box.edges()[a];
        reach_[k] = static_cast<int>(std::ceil(range * safety * inverse_width_[a]));
    }
    find_rows(range * safety);
}

void CellGrid::find_rows(double range) {
    rows_.clear();
    // Between cells n apart along an axis lie n - 1 whole cells.
    const auto between = [&](int offset, int axis) { return std::max(0, std::abs(offset) - 1) / inverse_width_[axis]; };
    for (int dz = -reach_[2]; dz <= reach_[2]; ++dz) {
        for (int dy = -reach_[1]; dy <= reach_[1]; ++dy) {
            const double along_y = between(dy, 1);
            const double along_z = between(dz, 2);
            const double left = range * range - along_y * along_y - along_z * along_z;
            if (left >= 0.0) {
                rows_.push_back(
                    {dz * static_cast<std::ptrdiff_t>(layer()) + dy * static_cast<std::ptrdiff_t>(row_length()),
                     static_cast<std::size_t>(std::ceil(std::sqrt(left) * inverse_width_[0]))});
            }
        }
    }
}

CellGrid::Cell CellGrid::cell_of(const Vec3& position) const {
    Cell cell{};
    for (int a = 0; a < 3; ++a) {
        const auto k = static_cast<std::size_t>(a);
        const int n = floor_of(position[a] * inverse_width_[a]);
        cell[k] = std::clamp(n, 0, inner_[k] - 1) + reach_[k];
    }
    return cell;
}

std::size_t CellGrid::flat(const Cell& cell) const {
    return static_cast<std::size_t>(cell[2]) * layer() + static_cast<std::size_t>(cell[1]) * row_length() +
           static_cast<std::size_t>(cell[0]);
}

std::size_t CellGrid::cell_count() const {
    return layer() * static_cast<std::size_t>(cells_along(2));
}

void CellGrid::sort(State& state, GhostExchange& ghosts) {
    require_countable(state.count());
    state.wrap();
    state.reorder(spatial_order(state));
    ghosts.create(state, place_atoms_and_images(state));
}

std::vector<Index> CellGrid::spatial_order(const State& state) {
    const auto r = state.positions();
    std::vector<std::uint32_t> cell(static_cast<std::size_t>(state.count()));
    for_each_index(state.execution(), state.count(), [&](Index i) {
        cell[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(flat(cell_of(r.col(i))));
    });
    sort_by(cell, cell_count(), starts_, order_);
    std::vector<Index> order(cell.size());
    for_each_block(state.execution(), static_cast<Index>(cell_count()), loop_block, [&](Index first, Index last) {
        for (auto c = static_cast<std::size_t>(first); c < static_cast<std::size_t>(last); ++c) {
            const auto begin = order_.begin() + starts_[c];
            const auto end = order_.begin() + starts_[c + 1];
            std::sort(begin, end, [&](std::int32_t i, std::int32_t j) {
                return state.ids()[static_cast<std::size_t>(i)] < state.ids()[static_cast<std::size_t>(j)];
            });
            std::copy(begin, end, order.begin() + starts_[c]);
        }
    });
    return order;
}

std::vector<GhostExchange::Run> CellGrid::place_atoms_and_images(const State& state) {
    const std::vector<std::uint32_t> atoms = std::exchange(starts_, {});  // for the cells in the box
    starts_.reserve(atoms.size());
    order_.clear();
    std::vector<GhostExchange::Run> images;
    Index ghosts = 0;
    // Which image a cell belongs to, in box edges along an axis; 0 in the box.
    const auto crossings = [&](int cell, std::size_t axis) {
        return floor_of(static_cast<double>(cell - reach_[axis]) / inner_[axis]);
    };
    for (int z = 0; z < cells_along(2); ++z) {
        for (int y = 0; y < cells_along(1); ++y) {
            for (int x = 0; x < cells_along(0); ++x) {
                const Cell n{crossings(x, 0), crossings(y, 1), crossings(z, 2)};
                const std::size_t owner = flat({x - n[0] * inner_[0], y - n[1] * inner_[1], z - n[2] * inner_[2]});
                const auto first = static_cast<Index>(atoms[owner]);
                const Index count = static_cast<Index>(atoms[owner + 1]) - first;
                starts_.push_back(static_cast<std::uint32_t>(order_.size()));
                if (n == Cell{}) {
                    append_range(order_, first, count);
                    continue;
                }
                append_range(order_, state.count() + ghosts, count);
                ghosts += count;
                const Vec3 shift = Vec3(n[0], n[1], n[2]).cwiseProduct(state.box().edges());
                if (!images.empty() && images.back().first + images.back().count == first &&
                    images.back().shift == shift) {
                    images.back().count += count;
                } else {
                    images.push_back({first, count, shift});
                }
            }
        }
    }
    starts_.push_back(static_cast<std::uint32_t>(order_.size()));
    return images;
}

}  // namespace ljmd
