#include "ljmd/forces/pair_force_field.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/forces/pair_sum.hpp"

namespace ljmd {

const SearchStatistics& PairForceField::search_statistics() const {
    return std::visit([](const auto& search) -> const SearchStatistics& { return search.statistics(); }, search_);
}

Evaluation PairForceField::compute(State& state, Request request) {
    const double cutoff = potential_.cutoff().radius;
    if (cutoff > 0.5 * state.box().shortest_edge()) {
        throw ContractViolation(
            fmt::format("cutoff {} exceeds half the shortest edge {} of the box", cutoff, state.box().shortest_edge()));
    }
    return std::visit(
        [&](auto& search) {
            search.prepare(state, cutoff);
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

}  // namespace ljmd
