#include "forces/pair_force_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "core/prefetch.hpp"
#include "core/stopwatch.hpp"
#include "execution/flush_subnormals.hpp"
#include "execution/loops.hpp"
#include "execution/thread_team.hpp"
#include "forces/evaluation_sum.hpp"
#include "forces/pair_sum.hpp"
#include "forces/simd/pair_kernel.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Coordinate of slots without an atom: out of reach even of images, but near enough that powers of the distance do not
/// overflow.
constexpr double far_away = -1e9;

}  // namespace

PairForceField::PairForceField(PairPotential potential, PairSearch search, const Execution& execution)
    : potential_(std::move(potential)),
      search_(std::move(search)),
      simd_(execution.simd()),
      precision_(execution.precision()) {
    if (auto* list = std::get_if<VerletList>(&search_)) {
        list->prepare_for(simd_, pair_kernels(simd_).row_shapes[static_cast<std::size_t>(precision_)]);
    } else if (precision_ == Precision::mixed) {
        throw ContractViolation("mixed precision needs a Verlet list");
    } else if (!execution.ranks().alone()) {
        throw ContractViolation("ranks share atoms only with a Verlet list");
    }
    if (precision_ == Precision::mixed && potential_.is_custom()) {
        throw ContractViolation("a potential without kernels is summed in double precision");
    }
}

void PairForceField::set_external(std::shared_ptr<ExternalForce> force) {
    external_.reset();
    if (force) {
        external_.emplace(std::move(force));
    }
}

const SearchStatistics& PairForceField::search_statistics() const {
    return std::visit([](const auto& search) -> const SearchStatistics& { return search.statistics(); }, search_);
}

void PairForceField::archive(Archive& a, State& state) {
    a.mark("pair search");
    std::visit([&](auto& search) { search.archive(a, state, potential_.cutoff().radius); }, search_);
    a(seconds_summing_);
}

Evaluation PairForceField::compute(State& state, Request request) {
    const double cutoff = potential_.cutoff().radius;
    if (cutoff > 0.5 * state.box().shortest_edge()) {
        throw ContractViolation(
            fmt::format("cutoff {} exceeds half the shortest edge {} of the box", cutoff, state.box().shortest_edge()));
    }
    if (VerletList* list = list_for_kernel(request)) {
        list->begin_preparing(state, cutoff);
    } else {
        std::visit([&](auto& search) { search.prepare(state, cutoff); }, search_);
    }
    Stopwatch watch;
    Evaluation evaluation = sum(state, request);
    if (external_) {
        external_->add(state, request, evaluation);
    }
    seconds_summing_ += watch.lap();
    return evaluation;
}

VerletList* PairForceField::list_for_kernel(Request request) {
    return request.order_independent || potential_.is_custom() ? nullptr : std::get_if<VerletList>(&search_);
}

Evaluation PairForceField::sum(State& state, Request request) {
    const double cutoff = potential_.cutoff().radius;
    if (VerletList* list = list_for_kernel(request)) {
        return sum_by_kernel(*list, state, request.energy);
    }
    return std::visit(
        [&]<class Search>(const Search& search) {
            return potential_.visit([&]<class Pair>(const Pair& pair) {
                // Each of these sums is compiled for every pair formula, truncation and search. To save compile time,
                // order-independent sums, which one integrator needs, always compute the energy.
                constexpr bool has_kernel = std::is_same_v<Search, VerletList> && !std::is_same_v<Pair, CustomPair>;
                if constexpr (!has_kernel) {
                    if (!request.order_independent) {
                        return request.energy ? sum_pairs<Request::forces_and_energy>(pair, search, cutoff, state)
                                              : sum_pairs<Request::forces>(pair, search, cutoff, state);
                    }
                }
                constexpr Request exact{.energy = true, .order_independent = true};
                return sum_pairs<exact>(pair, search, cutoff, state);
            });
        },
        search_);
}

Evaluation PairForceField::sum_by_kernel(VerletList& list, State& state, bool energy) {
    const State& atoms = state;
    const ClusterGrid& grid = list.clusters();
    const FixedPoint& fixed_point = list.fixed_point();
    const bool mixed = precision_ == Precision::mixed;
    const void* pair = potential_.visit([](const auto& any) -> const void* { return &any; });
    const PairKernels& kernels = pair_kernels(simd_);
    const auto precision = static_cast<std::size_t>(precision_);
    const PairKernel kernel = kernels.by_precision[precision].at(potential_.index())[energy ? 1 : 0];
    const auto tiles = list.tiles();
    std::vector<PairKernelSums> sums(energy ? tiles.size() : 0);
    const double cutoff = potential_.cutoff().radius;
    double* forces = state.write_forces().data();
    const auto sum_tile = [&](std::size_t t, Workspace& workspace) {
        constexpr std::size_t per_cluster = std::size_t{3} * ClusterGrid::slots;
        const VerletList::Tile& tile = tiles[t];
        const ClusterGrid::Run own = grid.tiles()[t];
        if (mixed) {
            workspace.fixed_positions.update(
                grid, own, tile.ghosts, tile.cluster_count, atoms, fixed_point,
                [&](double dx) { return fixed_point.distance(dx); }, FixedPoint::far_away);
        } else {
            workspace.positions.update(
                grid, own, tile.ghosts, tile.cluster_count, atoms, [](double x, int) { return x; },
                [](double dx) { return dx; }, far_away);
        }
        const auto partial = kernels.numbers_per_cluster[precision] * static_cast<std::size_t>(tile.cluster_count);
        workspace.partial_forces.resize(std::max(workspace.partial_forces.size(), partial));
        ghost_forces_[t].resize(per_cluster * static_cast<std::size_t>(tile.cluster_count - own.length()) + 1);
        const PairKernelTask task{
            mixed ? static_cast<const void*>(workspace.fixed_positions.data()) : workspace.positions.data(),
            fixed_point.unit(),
            own.length(),
            tile.cluster_count,
            grid.first_atoms().data() + own.first,
            tile.entries.data(),
            tile.starts.data(),
            cutoff * cutoff,
            workspace.partial_forces.data(),
            forces,
            ghost_forces_[t].data()};
        kernel(pair, task, energy ? &sums[t] : nullptr);
    };
    workspaces_.resize(static_cast<std::size_t>(state.execution().threads()));
    ghost_forces_.resize(tiles.size());
    const auto sum_tiles = [&](const TileOrder::Part& part) {
        const auto sum_in_workspace = [&](Index k, Index) {
            const FlushSubnormals flush_subnormals;
            sum_tile(static_cast<std::size_t>(part.tiles[static_cast<std::size_t>(k)]),
                     workspaces_[static_cast<std::size_t>(number_in_team())]);
        };
        for_each_block(state.execution(), static_cast<Index>(part.tiles.size()), 1, sum_in_workspace, part.work_before);
    };
    Ranks& ranks = state.execution().ranks();
    sum_tiles(list.order().while_positions_arrive());
    list.wait_for_halo(state);
    sum_tiles(list.order().with_halo());
    list.routes().begin_exchange(ranks, ghost_forces_);
    sum_tiles(list.order().while_forces_return());
    ranks.finish_exchange();
    add_ghost_forces(list, state);
    if (!energy) {
        return {};
    }
    EvaluationSum total;
    for (const PairKernelSums& tile : sums) {
        total.add(tile.energy, tile.virial);
    }
    return total.value(ranks);
}

/// Add the forces on a tile's clusters where these are ghosts of other tiles, in the order of those tiles.
void PairForceField::add_ghost_forces(const VerletList& list, State& state) const {
    double* forces = state.write_forces().data();
    const auto found_by = [&](const GhostRoutes::Export& one) {
        return (one.tile < 0 ? list.routes().received() : ghost_forces_[static_cast<std::size_t>(one.tile)].data()) +
               one.offset;
    };
    const auto add_to_tile = [&](Index tile, Index) {
        constexpr std::size_t ahead = 4;  // they lie here and there, and in large systems in no cache
        const auto exports = list.routes().of_tile(tile);
        for (std::size_t e = 0; e < exports.size(); ++e) {
            if (e + ahead < exports.size()) {
                const GhostRoutes::Export& soon = exports[e + ahead];
                prefetch(found_by(soon), found_by(soon) + std::ptrdiff_t{3} * soon.count);
                const double* to = forces + vector_stride * Index{soon.first};
                prefetch(to, to + vector_stride * Index{soon.count});
            }
            const double* from = found_by(exports[e]);
            const Index first = exports[e].first;
            for (Index i = first; i < first + Index{exports[e].count}; ++i, from += 3) {
                Eigen::Map<Vec3>(forces + vector_stride * i) += Eigen::Map<const Vec3>(from);
            }
        }
    };
    for_each_block(state.execution(), static_cast<Index>(list.tiles().size()), 1, add_to_tile, list.work_before());
}

}  // namespace ljmd
