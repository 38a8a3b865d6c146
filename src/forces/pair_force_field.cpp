#include "ljmd/forces/pair_force_field.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/stopwatch.hpp"
#include "ljmd/core/threads.hpp"
#include "ljmd/forces/pair_sum.hpp"
#include "simd/pair_kernel.hpp"

namespace ljmd {

PairForceField::PairForceField(PairPotential potential, PairSearch search, PairArithmetic arithmetic)
    : potential_(std::move(potential)), search_(std::move(search)), arithmetic_(arithmetic) {
    if (auto* list = std::get_if<VerletList>(&search_)) {
        const auto precision = static_cast<std::size_t>(arithmetic_.precision);
        list->prepare_for(arithmetic_.simd, pair_kernels(arithmetic_.simd).lanes[precision]);
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
    const bool mixed = arithmetic_.precision == Precision::mixed;
    if (mixed) {
        update_fixed_positions(list.fixed_point(), atoms);
    }
    const void* pair = potential_.visit([](const auto& any) -> const void* { return &any; });
    const PairKernel kernel = pair_kernels(arithmetic_.simd)
                                  .by_precision[static_cast<std::size_t>(arithmetic_.precision)]
                                  .at(potential_.index())[energy ? 1 : 0];
    const auto blocks = list.blocks();
    std::vector<PairKernelSums> sums(energy ? blocks.size() : 0);
    const double cutoff = potential_.cutoff().radius;
    const double* positions = atoms.positions().data();
    double* forces = state.write_forces().data();
    for_each_block(atoms.count(), VerletList::atoms_per_block, [&](Index first, Index last) {
        const auto b = static_cast<std::size_t>(first / VerletList::atoms_per_block);
        const PairKernelTask task{positions,
                                  fixed_positions_.data(),
                                  list.fixed_point().unit(),
                                  first,
                                  static_cast<int>(last - first),
                                  blocks[b].entries.data(),
                                  blocks[b].starts.data(),
                                  cutoff * cutoff,
                                  forces};
        kernel(pair, task, energy ? &sums[b] : nullptr);
    });
    Evaluation total;
    for (const PairKernelSums& block : sums) {
        const auto& w = block.virial;
        Mat3 virial;
        virial << w[0], w[3], w[4], w[3], w[1], w[5], w[4], w[5], w[2];
        total.potential_energy += 0.5 * block.energy;  // every pair was seen from both sides
        total.virial += 0.5 * virial;
    }
    return total;
}

void PairForceField::update_fixed_positions(const FixedPoint& fixed_point, const State& state) {
    const auto r = state.positions_and_ghosts();
    fixed_positions_.resize(4 * static_cast<std::size_t>(r.cols() + 1));
    for_each_index(r.cols(), [&](Index i) {
        std::int32_t* q = fixed_positions_.data() + 4 * i;
        for (int a = 0; a < 3; ++a) {
            q[a] = fixed_point(r(a, i), a);
        }
    });
    std::fill(fixed_positions_.end() - 4, fixed_positions_.end(), FixedPoint::far_away);
}

}  // namespace ljmd
