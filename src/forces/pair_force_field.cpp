#include "ljmd/forces/pair_force_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/core/threads.hpp"
#include "ljmd/forces/pair_sum.hpp"
#include "simd/pair_kernel.hpp"

namespace ljmd {

namespace {

/// Out of reach of everything, shifted by edges or not, and not so far that powers of the distance overflow.
constexpr double far_away = -1e9;

/// Bytes that a tile's partial forces take in double, a whole number of cache lines. One thread uses them for its tiles
/// in turn: they stay in the cache next to its core.
std::size_t room_for_partial_forces(const VerletList& list) {
    std::int32_t most = 0;
    for (const ClusterGrid::Run& tile : list.clusters().tiles()) {
        most = std::max(most, tile.length());
    }
    constexpr std::size_t line = 64;
    const auto numbers = static_cast<std::size_t>(Index{most} * 3 * ClusterGrid::slots * list.atoms_per_row());
    return (numbers * sizeof(double) + line - 1) / line * line;
}

}  // namespace

PairForceField::PairForceField(PairPotential potential, PairSearch search, PairArithmetic arithmetic)
    : potential_(std::move(potential)), search_(std::move(search)), arithmetic_(arithmetic) {
    if (auto* list = std::get_if<VerletList>(&search_)) {
        const auto precision = static_cast<std::size_t>(arithmetic_.precision);
        list->prepare_for(arithmetic_.simd, pair_kernels(arithmetic_.simd).atoms_per_row[precision]);
    } else if (arithmetic_.precision == Precision::mixed) {
        throw ContractViolation("mixed precision needs a Verlet list");
    }
}

const SearchStatistics& PairForceField::search_statistics() const {
    return std::visit([](const auto& search) -> const SearchStatistics& { return search.statistics(); }, search_);
}

void PairForceField::archive(Archive& a, const State& state) {
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
    std::visit([&](auto& search) { search.prepare(state, cutoff); }, search_);
    Stopwatch watch;
    const Evaluation evaluation = sum(state, request);
    seconds_summing_ += watch.lap();
    return evaluation;
}

Evaluation PairForceField::sum(State& state, Request request) {
    const double cutoff = potential_.cutoff().radius;
    if (const auto* list = std::get_if<VerletList>(&search_); list != nullptr && !request.order_independent) {
        return sum_by_kernel(*list, state, request.energy);
    }
    return std::visit(
        [&](const auto& search) {
            return potential_.visit([&](const auto& pair) {
                constexpr Request exact_forces{.order_independent = true};
                constexpr Request exact_forces_and_energy{.energy = true, .order_independent = true};
                if (request.order_independent) {
                    return request.energy ? sum_pairs<exact_forces_and_energy>(pair, search, cutoff, state)
                                          : sum_pairs<exact_forces>(pair, search, cutoff, state);
                }
                return request.energy ? sum_pairs<Request::forces_and_energy>(pair, search, cutoff, state)
                                      : sum_pairs<Request::forces>(pair, search, cutoff, state);
            });
        },
        search_);
}

Evaluation PairForceField::sum_by_kernel(const VerletList& list, State& state, bool energy) {
    const State& atoms = state;
    const ClusterGrid& clusters = list.clusters();
    const bool mixed = arithmetic_.precision == Precision::mixed;
    if (mixed) {
        const FixedPoint& fixed_point = list.fixed_point();
        fixed_positions_.update(
            clusters, atoms, fixed_point, [&](double dx) { return fixed_point.distance(dx); }, FixedPoint::far_away);
    } else {
        positions_.update(
            clusters, atoms, [](double x, int) { return x; }, [](double dx) { return dx; }, far_away);
    }
    const void* pair = potential_.visit([](const auto& any) -> const void* { return &any; });
    const PairKernel kernel = pair_kernels(arithmetic_.simd)
                                  .by_precision[static_cast<std::size_t>(arithmetic_.precision)]
                                  .at(potential_.index())[energy ? 1 : 0];
    const auto tiles = list.tiles();
    std::vector<PairKernelSums> sums(energy ? tiles.size() : 0);
    const double cutoff = potential_.cutoff().radius;
    double* forces = state.write_forces().data();
    const auto count = static_cast<Index>(tiles.size());
    const Index workers = std::min<Index>(thread_count(), count);
    const std::size_t room = room_for_partial_forces(list);
    partial_forces_.resize(room * static_cast<std::size_t>(workers));
    for_each_block(workers, 1, [&](Index worker, Index) {
        for (Index tile = worker * count / workers; tile < (worker + 1) * count / workers; ++tile) {
            const auto t = static_cast<std::size_t>(tile);
            const PairKernelTask task{mixed ? static_cast<const void*>(fixed_positions_.data()) : positions_.data(),
                                      list.fixed_point().unit(),
                                      clusters.tiles()[t],
                                      clusters.first_atoms().data(),
                                      tiles[t].entries.data(),
                                      tiles[t].starts.data(),
                                      cutoff * cutoff,
                                      partial_forces_.data() + room * static_cast<std::size_t>(worker),
                                      forces};
            kernel(pair, task, energy ? &sums[t] : nullptr);
        }
    });
    Evaluation total;
    for (const PairKernelSums& tile : sums) {
        const auto& w = tile.virial;
        Mat3 virial;
        virial << w[0], w[3], w[4], w[3], w[1], w[5], w[4], w[5], w[2];
        total.potential_energy += 0.5 * tile.energy;  // both sides of every pair were added up
        total.virial += 0.5 * virial;
    }
    return total;
}

}  // namespace ljmd
