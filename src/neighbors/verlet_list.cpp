#include "ljmd/neighbors/verlet_list.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/core/threads.hpp"
#include "simd/list_kernel.hpp"

namespace ljmd {

namespace {

/// Room that grows by a sixteenth more than is asked for: by as much again, as vectors do, a list would waste memory.
/// @param usual  what a first list begins with, so that it need not grow many times
void make_room(std::vector<std::int32_t>& entries, std::size_t size, std::size_t usual) {
    if (entries.size() < size) {
        const std::size_t room = entries.empty() ? std::max(size, usual) : size + size / 16;
        entries.reserve(room);
        entries.resize(room);
    }
}

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
        grid_.configure(state.box(), cutoff + skin_, state.count());
        grid_.sort(state, ghosts_);
        statistics_.seconds_sorting += watch.lap();
        build(state, cutoff);
        age_ = 1;
    }
    statistics_.seconds_listing += watch.lap();
}

bool VerletList::still_valid(const State& state, double cutoff) const {
    if (cutoff != built_for_cutoff_ || state.box().edges() != built_for_edges_ ||
        state.order_version() != built_for_order_ || state.ghost_count() != ghosts_.count() ||
        lanes_ != built_for_lanes_) {
        return false;
    }
    return every_ ? age_ < *every_ : nothing_moved_too_far(state);
}

bool VerletList::nothing_moved_too_far(const State& state) const {
    const double* reference = reference_.data();
    const double* r = state.positions().data();
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

void VerletList::build(const State& state, double cutoff) {
    const double range = cutoff + skin_;
    fixed_point_ = FixedPoint(state.box(), 2.0 * range);
    find_candidates(state.positions_and_ghosts());

    blocks_.resize(static_cast<std::size_t>((state.count() + atoms_per_block - 1) / atoms_per_block));
    using Counts = std::array<Index, 2>;
    const auto fill = [&](Index first, Index last) {
        return fill_block(blocks_[static_cast<std::size_t>(first / atoms_per_block)], state, first, last, range);
    };
    const auto [neighbors, tests] =
        join_blocks(state.count(), atoms_per_block, Counts{}, fill, [](Counts& sum, const Counts& block) {
            sum[0] += block[0];
            sum[1] += block[1];
        });
    entries_ = neighbors;
    statistics_.distance_tests += tests;

    reference_.resize(4 * static_cast<std::size_t>(state.count()));
    for_each_index(state.count(), [&, r = state.positions().data()](Index i) {
        std::copy_n(r + 4 * i, 4, reference_.data() + 4 * i);
    });
    built_for_cutoff_ = cutoff;
    built_for_edges_ = state.box().edges();
    built_for_order_ = state.order_version();
    built_for_lanes_ = lanes_;
    ++statistics_.rebuilds;
}

void VerletList::find_candidates(const ConstVectorView& points) {
    const auto order = grid_.order();
    candidates_.resize(order.size());
    for_each_index(static_cast<Index>(order.size()), [&](Index k) {
        const auto place = static_cast<std::size_t>(k);
        const auto r = points.col(order[place]);
        for (int a = 0; a < 3; ++a) {
            candidates_.places[static_cast<std::size_t>(a)][place] = static_cast<float>(fixed_point_(r[a], a));
        }
        candidates_.index[place] = order[place];
    });
}

void VerletList::CandidateArrays::resize(std::size_t size) {
    for (auto& coordinates : places) {
        coordinates.resize(size + list_kernel_slack);
    }
    index.resize(size + list_kernel_slack);
}

std::array<Index, 2> VerletList::fill_block(Block& block, const State& state, Index first, Index last,
                                            double range) const {
    const auto r = state.positions();
    const ListKernel kernel = list_kernel(level_);
    const ConstCandidates all{candidates_.places[0].data(), candidates_.places[1].data(), candidates_.places[2].data(),
                              candidates_.index.data()};
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
    std::vector<CellGrid::Run> runs;
    runs.reserve(grid_.run_count());
    CandidateArrays near;
    std::size_t cell_of_candidates = std::numeric_limits<std::size_t>::max();
    int candidates = 0;
    std::size_t end = 0;
    block.starts.fill(0);
    for (Index i = first; i < last; ++i) {
        const Vec3 center = r.col(i);
        if (const std::size_t cell = grid_.cell_at(center); cell != cell_of_candidates) {
            cell_of_candidates = cell;
            runs.clear();
            std::size_t points = 0;
            grid_.for_each_run(cell, [&](CellGrid::Run run) {
                runs.push_back(run);
                points += static_cast<std::size_t>(run.length());
            });
            if (near.index.size() < points + list_kernel_slack) {
                near.resize(2 * points);
            }
            candidates =
                kernel.gather(all, runs.data(), static_cast<int>(runs.size()),
                              {near.places[0].data(), near.places[1].data(), near.places[2].data(), near.index.data()});
        }
        make_room(block.entries, end + static_cast<std::size_t>(candidates) + std::size_t{2} * list_kernel_slack,
                  usual);
        const int found = kernel.neighbors_of(
            {near.places[0].data(), near.places[1].data(), near.places[2].data(), near.index.data()}, candidates,
            place(center[0], 0), place(center[1], 1), place(center[2], 2), static_cast<std::int32_t>(i), range2,
            block.entries.data() + end);
        counts[0] += found;
        counts[1] += candidates;
        end += static_cast<std::size_t>(found);
        // Filling up to whole vectors, and a vector of it where there is no neighbour.
        std::fill_n(block.entries.begin() + static_cast<Index>(end), list_kernel_slack, filling);
        const std::size_t start = block.starts[static_cast<std::size_t>(i - first)];
        const auto lanes = static_cast<std::size_t>(lanes_);
        end = start + std::max((end - start + lanes - 1) / lanes, std::size_t{1}) * lanes;
        block.starts[static_cast<std::size_t>(i - first) + 1] = static_cast<std::uint32_t>(end);
    }
    return counts;
}

}  // namespace ljmd
