#include "ljmd/neighbors/verlet_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>

#include "ljmd/core/archived_count.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/core/threads.hpp"
#include "simd/list_kernel.hpp"

namespace ljmd {

namespace {

/// Room that grows by a sixteenth more than is asked for: by as much again, as vectors do, a list would waste memory.
void make_room(std::vector<std::int32_t>& entries, std::size_t size) {
    if (entries.size() < size) {
        const std::size_t room = size + size / 16;
        entries.reserve(room);
        entries.resize(room);
    }
}

/// The clusters that one cluster of a column can meet, of one kind.
class CandidatesOfCluster {
  public:
    CandidatesOfCluster(const ClusterGrid& grid, ListKernel kernel, const ConstCandidates& all)
        : grid_(grid), kernel_(kernel), all_(all) {}

    /// @param near  of the column
    void begin(const std::vector<ClusterGrid::Near>& near, bool once) {
        near_.clear();
        std::copy_if(near.begin(), near.end(), std::back_inserter(near_),
                     [once](const ClusterGrid::Near& other) { return other.once == once; });
        runs_.resize(near_.size());
    }

    /// Collect those with a number of at least `least`.
    void go_to(Index cluster, Index least) {
        const ClusterGrid::Extent& extent = grid_.extent(cluster);
        constexpr std::int32_t slots = ClusterGrid::slots;
        int runs = 0;
        std::int32_t points = 0;
        for (const ClusterGrid::Near& other : near_) {
            if (!grid_.may_reach(other, extent)) {
                continue;  // for most clusters, all columns of the next tiles along z
            }
            const ClusterGrid::Run window = grid_.window(other, extent);
            const ClusterGrid::Run run{
                (std::max(window.first, static_cast<std::int32_t>(least)) + other.column.offset) * slots,
                (window.last + other.column.offset) * slots};
            const bool any = run.first < run.last;
            runs_[static_cast<std::size_t>(runs)] = run;  // kept if there is one: a branch would be guessed wrong
            runs += any ? 1 : 0;
            points += any ? run.length() : 0;
        }
        if (arrays_.size() < static_cast<std::size_t>(points)) {
            arrays_.resize(2 * static_cast<std::size_t>(points));
        }
        count_ = runs == 0 ? 0 : kernel_.gather(all_, runs_.data(), runs, arrays_.write());
    }

    [[nodiscard]] ConstCandidates read() const { return arrays_.read(); }
    [[nodiscard]] int count() const { return count_; }

  private:
    const ClusterGrid& grid_;
    ListKernel kernel_;
    ConstCandidates all_;
    std::vector<ClusterGrid::Near> near_;
    std::vector<ClusterGrid::Run> runs_;
    CandidateArrays arrays_;
    int count_ = 0;
};

}  // namespace

void VerletList::prepare_for(SimdLevel level, int atoms_per_row) {
    if (atoms_per_row != 1 && atoms_per_row != 2 && atoms_per_row != 4) {
        throw ContractViolation(fmt::format("lists of {} atoms: 1, 2 or 4 can share one", atoms_per_row));
    }
    level_ = level;
    atoms_per_row_ = atoms_per_row;
}

void VerletList::prepare(State& state, double cutoff) {
    ++statistics_.preparations;
    Stopwatch watch;
    if (still_valid(state, cutoff)) {
        ++age_;
    } else {
        grid_.configure(state.box(), cutoff + skin_, state.count());
        grid_.sort(state);
        statistics_.seconds_sorting += watch.lap();
        build(state, cutoff);
        age_ = 1;
    }
    statistics_.seconds_listing += watch.lap();
}

bool VerletList::still_valid(const State& state, double cutoff) const {
    if (cutoff != built_for_cutoff_ || state.box().edges() != built_for_edges_ ||
        state.order_version() != built_for_order_ || atoms_per_row_ != built_for_atoms_per_row_) {
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

void VerletList::archive(Archive& a, const State& state, double cutoff) {
    bool built = built_for_cutoff_ == cutoff && built_for_order_ == state.order_version();
    AlignedVector<double> reference = reference_;
    Index age = age_;
    SearchStatistics statistics = statistics_;
    a(built, reference, age, statistics);
    if (!a.reading()) {
        return;
    }
    require_count(age);
    built_for_cutoff_ = -1.0;
    if (built) {
        State then = state;
        auto r = then.write_positions();
        if (reference.size() != 4 * static_cast<std::size_t>(then.count())) {
            throw CheckpointError("its list is one of another number of atoms");
        }
        for (Index i = 0; i < then.count(); ++i) {
            r.col(i) = ConstVectorView(reference.data(), 3, then.count()).col(i);
        }
        prepare(then, cutoff);
        if (then.ids() != state.ids()) {
            throw CheckpointError("its atoms do not lie in the order of its list");
        }
        built_for_order_ = state.order_version();
    }
    age_ = age;
    statistics_ = statistics;
}

void VerletList::build(const State& state, double cutoff) {
    const double range = cutoff + skin_;
    fixed_point_ = FixedPoint(state.box(), 2.0 * range);
    find_candidates(state);

    tiles_.resize(grid_.tiles().size());
    statistics_.distance_tests += join_blocks(
        static_cast<Index>(tiles_.size()), 1, Index{0},
        [&](Index tile, Index) { return fill(static_cast<std::size_t>(tile), state, range); },
        [](Index& sum, Index tests) { sum += tests; });

    reference_.resize(4 * static_cast<std::size_t>(state.count()));
    for_each_index(state.count(), [&, r = state.positions().data()](Index i) {
        std::copy_n(r + 4 * i, 4, reference_.data() + 4 * i);
    });
    built_for_cutoff_ = cutoff;
    built_for_edges_ = state.box().edges();
    built_for_order_ = state.order_version();
    built_for_atoms_per_row_ = atoms_per_row_;
    ++statistics_.rebuilds;
}

void VerletList::find_candidates(const State& state) {
    constexpr Index slots = ClusterGrid::slots;
    candidates_.resize(static_cast<std::size_t>(grid_.with_images() * slots));
    const Candidates to = candidates_.write();
    const auto r = state.positions();
    const auto place = [&](Index i, const Vec3& shift, int axis) {
        return static_cast<float>(fixed_point_(r(axis, i) + shift[axis], axis));
    };
    grid_.for_each_slot(
        [&](Index cluster, int k, Index i, const Vec3& shift) {
            const Index slot = cluster * slots + k;
            to.x[slot] = place(i, shift, 0);
            to.y[slot] = place(i, shift, 1);
            to.z[slot] = place(i, shift, 2);
            to.entry[slot] = static_cast<std::int32_t>(3 * cluster * slots);
        },
        [&](Index cluster, int k) { to.x[cluster * slots + k] = nowhere; });
}

Index VerletList::fill(std::size_t tile, const State& state, double range) {
    const auto r = state.positions();
    const ListKernel kernel = list_kernel(level_);
    const auto place = [&](double x, int axis) { return static_cast<float>(fixed_point_(x, axis)); };
    // Each coordinate may be off by 16.5 units, a distance by twice the root of three of that, and the kernel rounds:
    // no pair within range is lost, and one that is hardly farther away may be on the list.
    const double units = range / fixed_point_.unit() + 58.0;
    const auto range2 = static_cast<float>(units * units * (1.0 + 1e-6));

    std::vector<std::int32_t>& entries = tiles_[tile].entries;
    std::vector<std::uint32_t>& starts = tiles_[tile].starts;
    starts.clear();
    std::size_t end = 0;
    Index tests = 0;
    std::vector<ClusterGrid::Near> near;
    CandidatesOfCluster within_tile(grid_, kernel, candidates_.read());
    CandidatesOfCluster others(grid_, kernel, candidates_.read());
    const auto append = [&](const CandidatesOfCluster& candidates, const RowOfAtoms& row) {
        starts.push_back(static_cast<std::uint32_t>(end));
        make_room(entries, end + static_cast<std::size_t>(candidates.count() / ClusterGrid::slots) + list_kernel_slack);
        end += static_cast<std::size_t>(
            kernel.clusters_near(candidates.read(), candidates.count(), row, range2, entries.data() + end));
        tests += Index{candidates.count()} * row.count;
    };
    const ClusterGrid::Run columns = grid_.columns(tile);
    for (std::int32_t column = columns.first; column < columns.last; ++column) {
        grid_.find_near(column, near);
        within_tile.begin(near, true);
        others.begin(near, false);
        const ClusterGrid::Run clusters = grid_.clusters_of_column(column);
        for (Index cluster = clusters.first; cluster < clusters.last; ++cluster) {
            within_tile.go_to(cluster, cluster + 1);
            others.go_to(cluster, 0);
            const ClusterGrid::Members atoms = grid_.members(cluster);
            for (int k = 0; k < atoms.count; k += atoms_per_row_) {
                RowOfAtoms row;
                row.count = atoms_per_row_;
                for (int n = 0; n < atoms_per_row_ && k + n < atoms.count; ++n) {
                    const auto center = r.col(atoms.first + k + n);
                    row.x[n] = place(center[0], 0);
                    row.y[n] = place(center[1], 1);
                    row.z[n] = place(center[2], 2);
                }
                append(within_tile, row);
                append(others, row);
            }
        }
    }
    starts.push_back(static_cast<std::uint32_t>(end));
    return tests;
}

}  // namespace ljmd
