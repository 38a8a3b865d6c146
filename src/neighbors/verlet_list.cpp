#include "ljmd/neighbors/verlet_list.hpp"

#include <atomic>
#include <numeric>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/threads.hpp"
#include "simd/list_kernel.hpp"

namespace ljmd {

namespace {

/// Where the atoms were when the list was built; sorted with them.
std::size_t reference_of(State& state) {
    return state.register_vectors("neighbour list: positions at the last rebuild");
}

/// Room that grows by an eighth more than is asked for: by half, as vectors do, a list would waste too much memory.
void make_room(std::vector<std::int32_t>& entries, std::size_t size) {
    if (entries.size() < size) {
        entries.reserve(size + size / 8);
        entries.resize(size + size / 8);
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
    if (still_valid(state, cutoff)) {
        ++age_;
        ghosts_.update(state);
    } else {
        rebuild(state, cutoff);
        age_ = 1;
    }
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
    const auto reference = static_cast<const State&>(state).registered(reference_of(state));
    const auto r = static_cast<const State&>(state).positions();
    const double limit = 0.5 * skin_ * (1.0 - 0x1p-40);  // a hair less, for the rounding in the distances
    const double limit2 = limit * limit;
    std::atomic<bool> valid = true;
    for_each_block(state.count(), usual_block, [&](Index first, Index last) {
        bool near = true;
        for (Index i = first; i < last; ++i) {
            near = near && (r.col(i) - reference.col(i)).squaredNorm() <= limit2;  // NaN counts as moved
        }
        if (!near) {
            valid = false;
        }
    });
    return valid;
}

void VerletList::rebuild(State& state, double cutoff) {
    const double range = cutoff + skin_;
    state.wrap();
    grid_.configure(state.box(), range, state.count());
    state.reorder(grid_.spatial_order(state));
    ghosts_.create(state, range);
    const State& atoms = state;
    grid_.fill(atoms.positions_and_ghosts());
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
    for (auto& values : candidates_) {
        values.resize(order.size() + list_kernel_slack);
    }
    for_each_index(static_cast<Index>(order.size()), [&](Index k) {
        const auto place = static_cast<std::size_t>(k);
        const auto r = points.col(order[place]);
        for (int a = 0; a < 3; ++a) {
            candidates_[static_cast<std::size_t>(a)][place] = fixed_point_(r[a], a);
        }
        candidates_[3][place] = static_cast<std::int32_t>(4U * static_cast<std::uint32_t>(order[place]));
    });
}

std::array<Index, 2> VerletList::fill_block(Block& block, const State& state, Index first, Index last,
                                            double range) const {
    const auto r = state.positions();
    const ListKernel kernel = list_kernel(level_);
    const Candidates candidates{candidates_[0].data(), candidates_[1].data(), candidates_[2].data(),
                                candidates_[3].data()};
    // Both points may be off by half a unit, and the kernel rounds to single precision: no pair within range is lost,
    // and one that is hardly farther away may be on the list.
    const double units = range / fixed_point_.unit() + 2.0;
    const auto range2 = static_cast<float>(units * units * (1.0 + 1e-6));
    const auto filling = static_cast<std::int32_t>(4U * static_cast<std::uint32_t>(state.far_point()));

    std::array<Index, 2> counts{};
    std::vector<CellGrid::Run> runs(grid_.run_count());
    std::size_t end = 0;
    block.starts.fill(0);
    for (Index i = first; i < last; ++i) {
        const Vec3 center = r.col(i);
        int run_count = 0;
        std::int32_t tests = 0;
        grid_.for_each_run(center, [&](CellGrid::Run run) {
            runs[static_cast<std::size_t>(run_count)] = run;
            run_count += run.length() > 0 ? 1 : 0;
            tests += run.length();
        });
        make_room(block.entries, end + static_cast<std::size_t>(tests) + 2 * list_kernel_slack);
        const int found =
            kernel(candidates, runs.data(), run_count, fixed_point_(center[0], 0), fixed_point_(center[1], 1),
                   fixed_point_(center[2], 2), static_cast<std::int32_t>(4 * i), range2, block.entries.data() + end);
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
