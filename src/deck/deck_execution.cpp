#include "ljmd/deck/deck_execution.hpp"

#include "ljmd/execution/threads.hpp"

namespace ljmd {

ExecutionOptions execution_options(const Deck& deck, int threads, const std::string& simd) {
    const bool fluid = deck.kind() == DeckKind::fluid;
    return {.threads = threads > 0 ? threads : default_thread_count(),
            .simd = default_simd_level(simd),
            .precision = fluid ? precision_of(deck.fluid().performance.precision) : Precision::double_precision};
}

}  // namespace ljmd
