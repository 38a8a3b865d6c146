#include "ljmd/forces/pair_force_field.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/core/threads.hpp"
#include "ljmd/forces/pair_sum.hpp"
#include "simd/pair_kernel.hpp"

namespace ljmd {

namespace {

/// Out of reach of everything, shifted by edges or not, and not so far that powers of the distance overflow.
constexpr double far_away = -1e9;

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
    const Index numbers = Index{3 * ClusterGrid::slots} * list.atoms_per_row();  // of partial forces, a cluster
    const auto room = static_cast<std::size_t>(numbers * clusters.cluster_count());
    if (mixed) {
        const FixedPoint& fixed_point = list.fixed_point();
        fixed_positions_.update(
            clusters, atoms, fixed_point, [&](double dx) { return fixed_point.distance(dx); }, FixedPoint::far_away);
        single_forces_.resize(room);
    } else {
        positions_.update(
            clusters, atoms, [](double x, int) { return x; }, [](double dx) { return dx; }, far_away);
        partial_forces_.resize(room);
    }
    const void* pair = potential_.visit([](const auto& any) -> const void* { return &any; });
    const PairKernel kernel = pair_kernels(arithmetic_.simd)
                                  .by_precision[static_cast<std::size_t>(arithmetic_.precision)]
                                  .at(potential_.index())[energy ? 1 : 0];
    const auto tiles = list.tiles();
    std::vector<PairKernelSums> sums(energy ? tiles.size() : 0);
    const double cutoff = potential_.cutoff().radius;
    double* forces = state.write_forces().data();
    for_each_block(static_cast<Index>(tiles.size()), 1, [&](Index tile, Index) {
        const auto t = static_cast<std::size_t>(tile);
        const ClusterGrid::Run of_tile = clusters.tiles()[t];
        const auto place = static_cast<std::size_t>(numbers * of_tile.first);
        const PairKernelTask task{
            mixed ? static_cast<const void*>(fixed_positions_.data()) : positions_.data(),
            list.fixed_point().unit(),
            of_tile,
            clusters.first_atoms().data(),
            tiles[t].entries.data(),
            tiles[t].starts.data(),
            cutoff * cutoff,
            mixed ? static_cast<void*>(single_forces_.data() + place) : partial_forces_.data() + place,
            forces};
        kernel(pair, task, energy ? &sums[t] : nullptr);
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
