#include "ljmd/deck/deck_execution.hpp"

#include "ljmd/execution/threads.hpp"

namespace ljmd {

ExecutionOptions execution_options(const Deck& deck, int threads, const std::string& simd) {
    return {.threads = threads > 0 ? threads : default_thread_count(),
            .simd = default_simd_level(simd),
            .precision = precision_of(deck)};
}

Precision precision_of(const Deck& deck) {
    return deck.kind() == DeckKind::fluid ? precision_of(deck.fluid().performance.precision)
                                          : Precision::double_precision;
}

}  // namespace ljmd
