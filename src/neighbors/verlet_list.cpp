#include "neighbors/verlet_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/resize_tightly.hpp"
#include "core/stopwatch.hpp"
#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/archived_count.hpp"
#include "model/shared_archive.hpp"
#include "neighbors/missed_pairs.hpp"
#include "neighbors/simd/list_kernel.hpp"

namespace ljmd {

namespace {

void make_room(std::vector<std::int32_t>& entries, std::size_t size) {
    if (entries.size() < size) {
        resize_tightly(entries, size);
        entries.resize(entries.capacity());
    }
}

/// The clusters that one cluster of a column can meet.
class CandidatesOfCluster {
  public:
    CandidatesOfCluster(const ClusterGrid& grid, ListKernel kernel, const ConstCandidates& all)
        : grid_(grid), kernel_(kernel), all_(all) {}

    /// Collect the clusters near a cluster; of its own tile, those after it. @param near  see ClusterGrid::find_near()
    void go_to(Index cluster, const std::vector<ClusterGrid::Near>& near) {
        const ClusterGrid::Extent& extent = grid_.extent(cluster);
        constexpr std::int32_t slots = ClusterGrid::slots;
        runs_.resize(near.size());
        int runs = 0;
        std::int32_t points = 0;
        for (const ClusterGrid::Near& other : near) {
            if (grid_.is_out_of_reach(other, extent)) {
                break;  // for most clusters at the first column of the next layer along z
            }
            const ClusterGrid::Run window = grid_.window(other, extent);
            const std::int32_t least = other.column.ghost ? 0 : static_cast<std::int32_t>(cluster) + 1;
            const ClusterGrid::Run run{(std::max(window.first, least) + other.column.offset) * slots,
                                       (window.last + other.column.offset) * slots};
            const bool any = run.first < run.last;
            runs_[static_cast<std::size_t>(runs)] = run;  // kept if not empty: a branch would be mispredicted
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
    std::vector<ClusterGrid::Run> runs_;
    CandidateArrays arrays_;
    int count_ = 0;
};

/// All slots of a tile and its ghost clusters, for the kernel. @param part  slots of a part, see RowShape
CandidateArrays candidates_of(const ClusterGrid& grid, const ClusterGrid::Neighborhood& neighborhood,
                              const State& state, const FixedPoint& fixed_point, Index part) {
    constexpr Index slots = ClusterGrid::slots;
    CandidateArrays candidates;
    candidates.resize(static_cast<std::size_t>(neighborhood.cluster_count() * slots));
    const Candidates to = candidates.write();
    const auto r = state.positions_and_ghosts();
    const auto place = [&](const ClusterGrid::Run& clusters, Index first, const Vec3& shift) {
        for (Index c = clusters.first; c < clusters.last; ++c) {
            const AtomRange atoms = grid.atoms_of_cluster(c);
            const Index number = first + c - clusters.first;
            for (Index k = 0; k < slots; ++k) {
                const Index slot = number * slots + k;
                to.entry[slot] = static_cast<std::int32_t>(3 * number * slots + k / part * part);
                if (k < atoms.count()) {
                    const Vec3 there = r.col(atoms.first + k) + shift;
                    to.x[slot] = static_cast<float>(fixed_point(there[0], 0));
                    to.y[slot] = static_cast<float>(fixed_point(there[1], 1));
                    to.z[slot] = static_cast<float>(fixed_point(there[2], 2));
                } else {
                    to.x[slot] = nowhere;
                    to.y[slot] = to.z[slot] = 0.0F;
                }
            }
        }
    };
    place(neighborhood.own(), 0, Vec3::Zero());
    for (const ClusterGrid::GhostClusters& ghosts : neighborhood.ghosts()) {
        place(ghosts.of, ghosts.first, ghosts.shift);
    }
    return candidates;
}

/// Give the atoms other positions. @param positions  vector_stride numbers an atom
void place(State& state, const double* positions) {
    auto r = state.write_positions();
    std::copy_n(positions, vector_stride * state.count(), r.data());
}

}  // namespace

void VerletList::prepare_for(SimdLevel level, RowShape shape) {
    if (shape != RowShape{1, 2} && shape != RowShape{2, 2} && shape != RowShape{2, 4} && shape != RowShape{4, 4}) {
        throw ContractViolation(
            fmt::format("rows of {} atoms that meet {} others: 1 can meet 2, 2 can meet 2 or 4, 4 can meet 4",
                        shape.atoms, shape.others));
    }
    level_ = level;
    shape_ = shape;
}

void VerletList::prepare(State& state, double cutoff) {
    begin_preparing(state, cutoff);
    wait_for_halo(state);
}

void VerletList::wait_for_halo(const State& state) {
    grid_.halo().finish_refresh(state.execution().ranks());
}

void VerletList::begin_preparing(State& state, double cutoff) {
    ++statistics_.preparations;
    Stopwatch watch;
    const bool shared = !state.execution().ranks().alone();
    if (shared && is_of(state, cutoff)) {
        grid_.halo().begin_refresh(state);
    }
    if (still_valid(state, cutoff)) {
        ++age_;
    } else {
        wait_for_halo(state);
        // any_pair_missed() would not do: a pair that came within the cutoff in between may have left it again.
        if (is_of(state, cutoff) && every_ && !nothing_moved_too_far(state)) {
            ++statistics_.late_rebuilds;
        }
        sort(state, cutoff);
        statistics_.seconds_sorting += watch.lap();
        build(state, cutoff);
        age_ = 1;
    }
    statistics_.seconds_listing += watch.lap();
}

void VerletList::sort(State& state, double cutoff, State* companion) {
    // A search for missed pairs looks a skin farther than the list, see any_pair_missed().
    const double halo = (cutoff + (every_ ? 1.0 : 2.0) * skin_) * (1.0 + 0x1p-20);  // rounding loses no column
    grid_.configure(state.box(), cutoff + skin_, state.total(), tile_, halo, state.execution().ranks());
    grid_.sort(state, companion);
}

bool VerletList::is_of(const State& state, double cutoff) const {
    return cutoff == built_for_cutoff_ && state.box().edges() == built_for_edges_ &&
           state.order_version() == built_for_order_ && shape_ == built_for_shape_;
}

bool VerletList::still_valid(const State& state, double cutoff) {
    if (!is_of(state, cutoff)) {
        return false;
    }
    if (every_) {
        return age_ < *every_;
    }
    if (nothing_moved_too_far(state)) {
        return true;
    }
    wait_for_halo(state);
    return !any_pair_missed(grid_, reference_.data(), state, cutoff, skin_);
}

bool VerletList::nothing_moved_too_far(const State& state) const {
    const double* before = reference_.data();
    const double* now = state.positions().data();
    const double limit = 0.5 * skin_ * (1.0 - 0x1p-40);  // slightly less, for rounding of the distances
    const double limit2 = limit * limit;
    std::atomic<bool> valid = true;
    for_each_range(state.execution(), state.count(), [&](Index first, Index last) {
        if (!valid.load(std::memory_order_relaxed)) {
            return;
        }
        Index near = 0;
        for (Index i = first; i < last; ++i) {
            near += squared_displacement(now, before, i) <= limit2 ? 1 : 0;  // NaN counts as moved
        }
        if (near < last - first) {
            valid = false;
        }
    });
    std::int64_t ranks_that_moved = valid ? 0 : 1;
    state.execution().ranks().sum({&ranks_that_moved, 1});
    return ranks_that_moved == 0;
}

void VerletList::archive(Archive& a, State& state, double cutoff) {
    // A list for another cutoff, box or order of the atoms is rebuilt at the next evaluation in any case.
    bool built = built_for_cutoff_ == cutoff && built_for_order_ == state.order_version() &&
                 built_for_edges_ == state.box().edges();
    Ranks& ranks = state.execution().ranks();
    SharedArchive atoms(a, ranks, state.count(), state.total());
    if (!a.reading()) {
        SearchStatistics statistics = statistics_;
        ranks.sum({&statistics.distance_tests, 1});
        if (ranks.is_root()) {
            a(built, age_, statistics);
        }
        if (built) {
            atoms.write(std::span<const double>(reference_), vector_stride);
        }
        return;
    }
    AlignedVector<double> reference;
    Index age = 0;
    SearchStatistics statistics;
    a(built, age, statistics);
    require_count(age);
    built_for_cutoff_ = -1.0;
    if (built) {
        atoms.read(reference, vector_stride, [](std::span<const double>) {});
        State then = state;
        place(then, reference.data());
        const std::vector<Index> ids = state.ids();
        sort(then, cutoff, &state);
        if (ranks.alone() && state.ids() != ids) {
            throw CheckpointError("its atoms are not in the order of its neighbour list");
        }
        build(then, cutoff);
        state.set_ghost_count(then.ghost_count());
        built_for_order_ = state.order_version();
    }
    age_ = age;
    statistics_ = statistics;
    if (!ranks.is_root()) {
        statistics_.distance_tests = 0;
    }
}

void VerletList::build(const State& state, double cutoff) {
    const double range = cutoff + skin_;
    fixed_point_ = FixedPoint(state.box(), 2.0 * range);
    tiles_.resize(grid_.tiles().size());
    statistics_.distance_tests += join_blocks(
        state.execution(), static_cast<Index>(tiles_.size()), 1, Index{0},
        [&](Index tile, Index) { return fill(static_cast<std::size_t>(tile), state, range); },
        [](Index& sum, Index tests) { sum += tests; });
    std::vector<std::span<const ClusterGrid::GhostClusters>> ghosts;
    ghosts.reserve(tiles_.size());
    for (const Tile& tile : tiles_) {
        ghosts.emplace_back(tile.ghosts);
    }
    routes_.find(grid_, ghosts, state.execution().ranks());
    measure_work(state.execution());

    const Index all = state.count() + state.ghost_count();
    resize_tightly(reference_, static_cast<std::size_t>(vector_stride * all));
    for_each_range(state.execution(), all, [&, r = state.positions().data()](Index first, Index last) {
        std::copy(r + vector_stride * first, r + vector_stride * last, reference_.data() + vector_stride * first);
    });
    built_for_cutoff_ = cutoff;
    built_for_edges_ = state.box().edges();
    built_for_order_ = state.order_version();
    built_for_shape_ = shape_;
    ++statistics_.rebuilds;
}

void VerletList::measure_work(const Execution& execution) {
    work_before_.assign(1, 0);
    std::vector<std::int64_t> work;
    std::vector<bool> needs_halo;
    for (std::size_t t = 0; t < tiles_.size(); ++t) {
        // An atom makes work by itself, about as much as ten entries.
        const AtomRange atoms = grid_.atoms_of_tile(static_cast<Index>(t));
        work.push_back(1 + static_cast<std::int64_t>(tiles_[t].starts.back()) + 10 * atoms.count());
        work_before_.push_back(work_before_.back() + work.back());
        needs_halo.push_back(
            std::any_of(tiles_[t].ghosts.begin(), tiles_[t].ghosts.end(),
                        [this](const ClusterGrid::GhostClusters& ghosts) { return grid_.is_abroad(ghosts.of.first); }));
    }
    order_.arrange(needs_halo, work, execution.threads());
    if (execution.ranks().alone()) {
        return;
    }
    std::vector<std::int64_t> of_all(static_cast<std::size_t>(grid_.tiles_of_all()), 0);
    std::copy(work.begin(), work.end(), of_all.begin() + grid_.first_tile());
    execution.ranks().sum(of_all);
    grid_.set_work(std::move(of_all));
}

Index VerletList::fill(std::size_t number, const State& state, double range) {
    const ListKernel kernel = list_kernel(level_.value_or(state.execution().simd()));
    // A coordinate may be off by 16.5 units, so a distance by twice that times the root of three; and the kernel
    // rounds. With this margin no pair within range is lost; a pair slightly beyond it may be on the list.
    const double units = range / fixed_point_.unit() + 58.0;
    const auto range2 = static_cast<float>(units * units * (1.0 + 1e-6));

    const ClusterGrid::Neighborhood neighborhood = grid_.neighborhood(number);
    const CandidateArrays arrays = candidates_of(grid_, neighborhood, state, fixed_point_, shape_.others);
    const ConstCandidates all = arrays.read();
    Tile& tile = tiles_[number];
    tile.ghosts = neighborhood.ghosts();
    tile.cluster_count = neighborhood.cluster_count();
    tile.starts.clear();
    std::size_t end = 0;
    Index tests = 0;
    constexpr Index slots_of_all = ClusterGrid::slots;
    const bool halves = shape_.others < slots_of_all;
    std::vector<std::int32_t> others;  // the second half of a row's list
    std::vector<ClusterGrid::Near> near;
    CandidatesOfCluster candidates(grid_, kernel, all);
    const ClusterGrid::Run columns = grid_.columns(number);
    for (std::int32_t column = columns.first; column < columns.last; ++column) {
        grid_.find_near(neighborhood, column, near);
        const ClusterGrid::Run clusters = grid_.clusters_of_column(column);
        for (Index cluster = clusters.first; cluster < clusters.last; ++cluster) {
            candidates.go_to(cluster, near);
            const Index atoms = grid_.atoms_of_cluster(cluster).count();
            const Index first_slot = (cluster - neighborhood.own().first) * slots_of_all;
            for (Index k = 0; k < atoms; k += shape_.atoms) {
                RowOfAtoms row{shape_};
                for (Index n = 0; n < shape_.atoms && k + n < atoms; ++n) {
                    row.x[n] = all.x[first_slot + k + n];
                    row.y[n] = all.y[first_slot + k + n];
                    row.z[n] = all.z[first_slot + k + n];
                }
                const std::size_t room =
                    static_cast<std::size_t>(candidates.count() / slots_of_all) + list_kernel_slack;
                make_room(tile.entries, end + 2 * room);
                make_room(others, room);
                tile.starts.push_back(static_cast<std::uint32_t>(end));
                std::int32_t* const first = tile.entries.data() + end;
                const bool in_upper = k >= shape_.others;  // the row's own part
                const auto [lower, upper] =
                    kernel.parts_near(candidates.read(), candidates.count(), row, range2,
                                      in_upper ? others.data() : first, in_upper ? first : others.data());
                end += static_cast<std::size_t>(in_upper ? upper : lower);
                if (halves) {
                    tile.starts.push_back(static_cast<std::uint32_t>(end));
                    if (!in_upper && atoms > shape_.others) {
                        tile.entries[end++] = static_cast<std::int32_t>(3 * first_slot) + shape_.others;
                    }
                    const int rest = in_upper ? lower : upper;
                    std::copy_n(others.data(), rest, tile.entries.data() + end);
                    end += static_cast<std::size_t>(rest);
                }
                tests += Index{candidates.count()} * shape_.atoms;
            }
        }
    }
    tile.starts.push_back(static_cast<std::uint32_t>(end));
    make_room(tile.entries, end + list_kernel_slack);
    std::fill_n(tile.entries.begin() + static_cast<std::ptrdiff_t>(end), list_kernel_slack, 0);
    return tests;
}

}  // namespace ljmd
