#include "ljmd/neighbors/verlet_list.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/core/threads.hpp"
#include "simd/list_kernel.hpp"

namespace ljmd {

namespace {

/// Where the atoms were when the list was built; sorted with them.
std::size_t reference_of(State& state) {
    return state.register_vectors("neighbour list: positions at the last rebuild");
}

/// Room that grows by a sixteenth more than is asked for: by as much again, as vectors do, a list would waste memory.
/// @param usual  what a first list begins with, so that it need not grow many times
void make_room(std::vector<std::int32_t>& entries, std::size_t size, std::size_t usual) {
    if (entries.size() < size) {
        const std::size_t room = entries.empty() ? std::max(size, usual) : size + size / 16;
        entries.reserve(room);
        entries.resize(room);
    }
}

/// Runs of points, cut into pieces of as many as a kernel takes at a time.
class Pieces {
  public:
    /// @pre length is a power of two
    explicit Pieces(int length) : length_(length), shift_(std::countr_zero(static_cast<unsigned>(length))) {}

    void clear() { count_ = 0; }
    [[nodiscard]] const CellGrid::Run* data() const { return pieces_.data(); }
    [[nodiscard]] int count() const { return count_; }

    void add(CellGrid::Run run) {
        const int needed = (run.length() + length_ - 1) >> shift_;  // a division would take longer than the rest
        const auto room = static_cast<std::size_t>(count_) + static_cast<std::size_t>(std::max(needed, usual));
        if (pieces_.size() < room) {
            pieces_.resize(2 * room);
        }
        // The usual number is written whether there are so many or not: nothing then depends on a branch that the
        // processor cannot foresee.
        CellGrid::Run* piece = pieces_.data() + count_;
        for (int k = 0; k < usual; ++k) {
            piece[k] = piece_of(run, k);
        }
        for (int k = usual; k < needed; ++k) {
            piece[k] = piece_of(run, k);
        }
        count_ += needed;
    }

  private:
    static constexpr int usual = 3;

    [[nodiscard]] CellGrid::Run piece_of(CellGrid::Run run, int k) const {
        const std::int32_t first = run.first + k * length_;
        return {first, std::min(first + length_, run.last)};
    }

    int length_;
    int shift_;
    int count_ = 0;
    std::vector<CellGrid::Run> pieces_;
};

}  // namespace

void VerletList::prepare_for(SimdLevel level, int lanes) {
    if (lanes < 1 || lanes > list_kernel_slack) {
        throw ContractViolation("lists are filled up to 1 ... 16 lanes");
    }
    level_ = level;
    lanes_ = lanes;
}

void VerletList::prepare(State& state, double cutoff) {
    ++statistics_.preparations;
    Stopwatch watch;
    if (still_valid(state, cutoff)) {
        ++age_;
        ghosts_.update(state);
    } else {
        sort(state, cutoff + skin_);
        statistics_.seconds_sorting += watch.lap();
        build(state, cutoff);
        age_ = 1;
    }
    statistics_.seconds_listing += watch.lap();
}

bool VerletList::still_valid(State& state, double cutoff) {
    if (cutoff != built_for_cutoff_ || state.box().edges() != built_for_edges_ ||
        state.order_version() != built_for_order_ || state.ghost_count() != ghosts_.count() ||
        lanes_ != built_for_lanes_) {
        return false;
    }
    return every_ ? age_ < *every_ : nothing_moved_too_far(state);
}

bool VerletList::nothing_moved_too_far(State& state) const {
    const double* reference = static_cast<const State&>(state).registered(reference_of(state)).data();
    const double* r = static_cast<const State&>(state).positions().data();
    const double limit = 0.5 * skin_ * (1.0 - 0x1p-40);  // a hair less, for the rounding in the distances
    const double limit2 = limit * limit;
    std::atomic<bool> valid = true;
    for_each_block(state.count(), usual_block, [&](Index first, Index last) {
        Index near = 0;
        for (Index i = first; i < last; ++i) {
            const double dx = r[4 * i] - reference[4 * i];
            const double dy = r[4 * i + 1] - reference[4 * i + 1];
            const double dz = r[4 * i + 2] - reference[4 * i + 2];
            near += dx * dx + dy * dy + dz * dz <= limit2 ? 1 : 0;  // NaN counts as moved
        }
        if (near < last - first) {
            valid = false;
        }
    });
    return valid;
}

void VerletList::sort(State& state, double range) {
    state.wrap();
    grid_.configure(state.box(), range, state.count());
    state.reorder(grid_.spatial_order(state));
    ghosts_.create(state, range);
    grid_.fill(static_cast<const State&>(state).positions_and_ghosts());
}

void VerletList::build(State& state, double cutoff) {
    const double range = cutoff + skin_;
    const State& atoms = state;
    fixed_point_ = FixedPoint(state.box(), 2.0 * range);
    gather_candidates(atoms.positions_and_ghosts());

    blocks_.resize(static_cast<std::size_t>((state.count() + atoms_per_block - 1) / atoms_per_block));
    std::vector<std::array<Index, 2>> counts(blocks_.size());
    for_each_block(state.count(), atoms_per_block, [&](Index first, Index last) {
        const auto b = static_cast<std::size_t>(first / atoms_per_block);
        counts[b] = fill_block(blocks_[b], atoms, first, last, range);
    });
    entries_ = 0;
    for (const auto& [neighbors, tests] : counts) {
        entries_ += neighbors;
        statistics_.distance_tests += tests;
    }

    auto reference = state.registered(reference_of(state));
    const auto r = atoms.positions();
    for_each_index(state.count(), [&](Index i) { reference.col(i) = r.col(i); });
    built_for_cutoff_ = cutoff;
    built_for_edges_ = state.box().edges();
    built_for_order_ = state.order_version();
    built_for_lanes_ = lanes_;
    ++statistics_.rebuilds;
}

void VerletList::gather_candidates(const ConstVectorView& points) {
    const auto order = grid_.order();
    for (auto& values : candidate_places_) {
        values.resize(order.size() + list_kernel_slack);
    }
    candidate_entries_.resize(order.size() + list_kernel_slack);
    for_each_index(static_cast<Index>(order.size()), [&](Index k) {
        const auto place = static_cast<std::size_t>(k);
        const auto r = points.col(order[place]);
        for (int a = 0; a < 3; ++a) {
            candidate_places_[static_cast<std::size_t>(a)][place] = static_cast<float>(fixed_point_(r[a], a));
        }
        candidate_entries_[place] = static_cast<std::int32_t>(4U * static_cast<std::uint32_t>(order[place]));
    });
}

std::array<Index, 2> VerletList::fill_block(Block& block, const State& state, Index first, Index last,
                                            double range) const {
    const auto r = state.positions();
    const ListKernel kernel = list_kernel(level_);
    const Candidates candidates{candidate_places_[0].data(), candidate_places_[1].data(), candidate_places_[2].data(),
                                candidate_entries_.data()};
    const auto place = [&](double x, int axis) { return static_cast<float>(fixed_point_(x, axis)); };
    // Each coordinate may be off by 16.5 units, a distance by twice the root of three of that, and the kernel rounds:
    // no pair within range is lost, and one that is hardly farther away may be on the list.
    const double units = range / fixed_point_.unit() + 58.0;
    const auto range2 = static_cast<float>(units * units * (1.0 + 1e-6));
    const auto filling = static_cast<std::int32_t>(4U * static_cast<std::uint32_t>(state.far_point()));

    // Neighbours at the mean density and half a vector of filling, and some more for density's ups and downs.
    const double mean = static_cast<double>(state.count()) / state.box().volume() * 4.0 / 3.0 * std::numbers::pi *
                        range * range * range;
    const auto usual = static_cast<std::size_t>(1.06 * static_cast<double>(atoms_per_block) * (mean + 0.5 * lanes_));

    std::array<Index, 2> counts{};
    // Of the cell that the atom is in; the next atom is often in the same one.
    Pieces pieces(kernel.lanes);
    std::size_t cell_of_pieces = std::numeric_limits<std::size_t>::max();
    std::int32_t tests = 0;
    std::size_t end = 0;
    block.starts.fill(0);
    for (Index i = first; i < last; ++i) {
        const Vec3 center = r.col(i);
        if (const std::size_t cell = grid_.cell_at(center); cell != cell_of_pieces) {
            cell_of_pieces = cell;
            tests = 0;
            pieces.clear();
            grid_.for_each_run(cell, [&](CellGrid::Run run) {
                tests += run.length();
                pieces.add(run);
            });
        }
        make_room(block.entries, end + static_cast<std::size_t>(tests) + std::size_t{2} * list_kernel_slack, usual);
        const int found = kernel.neighbors_of(candidates, pieces.data(), pieces.count(), place(center[0], 0),
                                              place(center[1], 1), place(center[2], 2),
                                              static_cast<std::int32_t>(4 * i), range2, block.entries.data() + end);
        counts[0] += found;
        counts[1] += tests;
        end += static_cast<std::size_t>(found);
        const std::size_t start = block.starts[static_cast<std::size_t>(i - first)];
        while (end == start || (end - start) % static_cast<std::size_t>(lanes_) != 0) {
            block.entries[end++] = filling;
        }
        block.starts[static_cast<std::size_t>(i - first) + 1] = static_cast<std::uint32_t>(end);
    }
    return counts;
}

}  // namespace ljmd
