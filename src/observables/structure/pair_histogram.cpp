#include "observables/structure/pair_histogram.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "execution/loops.hpp"
#include "observables/simd/histogram_kernel.hpp"

namespace ljmd {

namespace {

/// Each block has its own histogram: enough blocks for many threads, few enough for long histograms.
constexpr Index max_blocks = 64;

/// Cells to search on each side; they are at least half the radius wide.
constexpr Index reach = 2;

/// Atoms sorted into cells, row by row along x, in a periodic box.
class Cells {
  public:
    Cells(const State& state, double radius);

    [[nodiscard]] Index atoms() const { return static_cast<Index>(x_.size()); }
    [[nodiscard]] Vec3 position(Index place) const {
        const auto k = static_cast<std::size_t>(place);
        return {x_[k], y_[k], z_[k]};
    }
    /// The atoms with places [first, last) in the order.
    [[nodiscard]] HistogramKernel::Points points(Index first, Index last) const {
        return {x_.data() + first, y_.data() + first, z_.data() + first, static_cast<int>(last - first)};
    }

    /// visit(first, last) for runs of places that together hold all atoms after `place` within the radius, each once.
    /// Adjacent runs are joined, because long runs are faster.
    template <class Visit>
    void for_each_run_behind(Index place, Visit visit) const;

  private:
    using Cell = std::array<Index, 3>;

    /// Cells to search along an edge: [begin, begin + count) modulo the number of cells.
    struct Window {
        Index begin;
        Index count;
    };
    [[nodiscard]] Window window(Index cell, std::size_t axis) const {
        const Index cells = cells_[axis];
        return cells > 2 * reach ? Window{(cell - reach + cells) % cells, 2 * reach + 1} : Window{0, cells};
    }
    [[nodiscard]] Cell cell_of(const Vec3& r) const;
    [[nodiscard]] Index flat(const Cell& c) const { return (c[2] * cells_[1] + c[1]) * cells_[0] + c[0]; }

    Vec3 edges_;
    Cell cells_{};
    std::vector<Index> starts_;  ///< place of the first atom in each cell
    std::vector<double> x_, y_, z_;
};

Cells::Cells(const State& state, double radius) : edges_(state.box().edges()) {
    for (std::size_t a = 0; a < 3; ++a) {
        const double fitting = std::floor(2.0 * edges_[static_cast<Index>(a)] / radius);
        // More cells along an edge than the cube root of the number of atoms would be mostly empty.
        cells_[a] = static_cast<Index>(std::clamp(fitting, 1.0, std::cbrt(static_cast<double>(state.count())) + 1.0));
    }
    const auto count = static_cast<std::size_t>(state.count());
    const auto r = state.positions();
    std::vector<Index> cells(count);
    starts_.assign(static_cast<std::size_t>(cells_[0] * cells_[1] * cells_[2] + 1), 0);
    const auto inside = [&](std::size_t i) -> Vec3 {
        const Vec3 position = r.col(static_cast<Index>(i));
        return position - state.box().crossings(position).cwiseProduct(edges_);
    };
    for (std::size_t i = 0; i < count; ++i) {
        cells[i] = flat(cell_of(inside(i)));
        ++starts_[static_cast<std::size_t>(cells[i] + 1)];
    }
    for (std::size_t c = 1; c < starts_.size(); ++c) {
        starts_[c] += starts_[c - 1];
    }
    std::vector<Index> next(starts_);
    x_.resize(count);
    y_.resize(count);
    z_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto place = static_cast<std::size_t>(next[static_cast<std::size_t>(cells[i])]++);
        const Vec3 position = inside(i);
        x_[place] = position[0];
        y_[place] = position[1];
        z_[place] = position[2];
    }
}

Cells::Cell Cells::cell_of(const Vec3& r) const {
    Cell cell{};
    for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<Index>(a);
        const auto k = static_cast<Index>(r[axis] / edges_[axis] * static_cast<double>(cells_[a]));
        cell[a] = std::clamp(k, Index{0}, cells_[a] - 1);
    }
    return cell;
}

template <class Visit>
void Cells::for_each_run_behind(Index place, Visit visit) const {
    const Cell cell = cell_of(position(place));
    Index run_first = 0;
    Index run_last = 0;
    const auto visit_cells = [&](Index first_cell, Index last_cell) {
        const Index first = std::max(starts_[static_cast<std::size_t>(first_cell)], place + 1);
        const Index last = starts_[static_cast<std::size_t>(last_cell)];
        if (first >= last) {
            return;
        }
        if (first != run_last) {
            if (run_first < run_last) {
                visit(run_first, run_last);
            }
            run_first = first;
        }
        run_last = last;
    };
    const Window x = window(cell[0], 0);
    const Window y = window(cell[1], 1);
    const Window z = window(cell[2], 2);
    const Index straight = std::min(x.count, cells_[0] - x.begin);  // the rest is at the beginning of the row
    for (Index k = 0; k < z.count; ++k) {
        for (Index j = 0; j < y.count; ++j) {
            const Index row = flat({0, (y.begin + j) % cells_[1], (z.begin + k) % cells_[2]});
            visit_cells(row + x.begin, row + x.begin + straight);
            visit_cells(row, row + x.count - straight);
        }
    }
    if (run_first < run_last) {
        visit(run_first, run_last);
    }
}

}  // namespace

std::vector<Index> pair_histogram(const State& state, double radius, Index bins) {
    const Cells cells(state, radius);
    const HistogramKernel kernel = histogram_kernel(state.execution().simd());
    const Vec3 edges = state.box().edges();
    const double per_length = static_cast<double>(bins) / radius;
    using Counts = std::vector<Index>;
    const auto count_block = [&](Index first, Index last) {
        Counts counts(static_cast<std::size_t>(bins + HistogramKernel::overflow_bins));
        std::vector<std::int32_t> found(static_cast<std::size_t>(cells.atoms()));
        for (Index place = first; place < last; ++place) {
            const Vec3 r = cells.position(place);
            cells.for_each_run_behind(place, [&](Index from, Index to) {
                kernel.bins_of(cells.points(from, to), r.data(), edges.data(), per_length,
                               static_cast<std::int32_t>(bins), found.data());
                for (Index k = 0; k < to - from; ++k) {
                    ++counts[static_cast<std::size_t>(found[static_cast<std::size_t>(k)])];
                }
            });
        }
        counts.resize(static_cast<std::size_t>(bins));
        return counts;
    };
    const Index atoms = cells.atoms();
    return join_blocks(state.execution(), atoms, std::max((atoms + max_blocks - 1) / max_blocks, Index{1}),
                       Counts(static_cast<std::size_t>(bins)), count_block, [](Counts& sum, const Counts& block) {
                           std::transform(sum.begin(), sum.end(), block.begin(), sum.begin(), std::plus<>());
                       });
}

}  // namespace ljmd
