#include "deck/deck_execution.hpp"
#include "deck/few_body_check.hpp"
#include "deck/fluid.hpp"
#include "deck_promises.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

/// What `ljmd check` makes of a good deck, but for the trial that tells how long a run will take.
void check_fluid(const Deck& deck) {
    constexpr Index many_atoms = 10000;  // those of a good deck may be more than there is memory for
    if (deck.system().file) {            // of whoever runs this
        return;
    }
    const Start start = find_start(deck);
    if (start.atoms <= many_atoms) {
        static_cast<void>(empty_fluid(fluid_spec(deck), start.atoms, start.box, Execution(execution_options(deck))));
    }
}

}  // namespace

LJMD_FUZZ_TARGET(deck) {
    Diagnostics diagnostics;
    const auto deck = load_deck_text("deck.toml", std::string(fuzz::text_of(data, size)), {}, false, diagnostics);
    fuzz::check_promises(deck, diagnostics);
    if (!deck) {
        return 0;
    }
    try {
        if (!deck->is_fluid()) {
            static_cast<void>(few_body_check_report(*deck));
        } else {
            check_fluid(*deck);
        }
    } catch (const PhysicsError&) {
    }
    return 0;
}
