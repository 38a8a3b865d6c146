#include "ljmd/neighbors/verlet_list.hpp"

namespace ljmd {

namespace {
/// Where the atoms were when the list was built; sorted with them.
std::size_t reference_of(State& state) {
    return state.register_vectors("neighbour list: positions at the last rebuild");
}
}  // namespace

void VerletList::prepare(State& state, double cutoff) {
    ++statistics_.preparations;
    if (still_valid(state, cutoff)) {
        ghosts_.update(state);
    } else {
        rebuild(state, cutoff);
    }
}

bool VerletList::still_valid(State& state, double cutoff) {
    if (cutoff != built_for_cutoff_ || state.box().edges() != built_for_edges_ ||
        state.order_version() != built_for_order_ || state.ghost_count() != ghosts_.count()) {
        return false;
    }
    const auto reference = state.registered(reference_of(state));
    const auto r = static_cast<const State&>(state).positions();
    const double limit = 0.5 * skin_ * (1.0 - 0x1p-40);  // a hair less, for the rounding in the distances
    for (Index i = 0; i < state.count(); ++i) {
        if (!((r.col(i) - reference.col(i)).squaredNorm() <= limit * limit)) {  // NaN counts as moved
            return false;
        }
    }
    return true;
}

void VerletList::rebuild(State& state, double cutoff) {
    const double range = cutoff + skin_;
    state.wrap();
    grid_.configure(state.box(), range, state.count());
    state.reorder(grid_.spatial_order(state));
    ghosts_.create(state, range);
    grid_.fill(state.positions_and_ghosts());

    const auto r = static_cast<const State&>(state).positions();
    starts_.assign(1, 0);
    neighbors_.clear();
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3 center = r.col(i);
        grid_.for_each_run(center, [&](std::span<const CellGrid::Entry> run) {
            statistics_.distance_tests += static_cast<Index>(run.size());
            for (const CellGrid::Entry& other : run) {
                const double dx = center[0] - other.x;
                const double dy = center[1] - other.y;
                const double dz = center[2] - other.z;
                // Summed in the order of the force loop: without skin both must round a pair at the cutoff alike.
                if (dx * dx + dy * dy + dz * dz < range * range && other.index != i) {
                    neighbors_.push_back(other.index);
                }
            }
        });
        starts_.push_back(neighbors_.size());
    }
    state.registered(reference_of(state)) = r;
    built_for_cutoff_ = cutoff;
    built_for_edges_ = state.box().edges();
    built_for_order_ = state.order_version();
    ++statistics_.rebuilds;
}

}  // namespace ljmd
