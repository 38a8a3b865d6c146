#include "deck/checked_run.hpp"

#include <utility>

#include "deck/deck_execution.hpp"
#include "deck/few_body_check.hpp"
#include "deck/forecast.hpp"
#include "deck/start_sense.hpp"

namespace ljmd {

CheckedRun checked_run(const Deck& deck, int threads, const std::string& simd, Diagnostics& diagnostics,
                       const std::shared_ptr<Ranks>& ranks) {
    if (!deck.is_fluid()) {
        return {std::nullopt, Execution()};
    }
    Start start = find_start(deck);
    ExecutionOptions options = execution_options(deck, threads, simd);
    options.ranks = ranks;
    Execution execution(options);
    if (start.configuration) {  // the box is known only now
        check_start(deck, start, diagnostics);
        diagnostics.throw_if_errors();
    }
    return {std::move(start), std::move(execution)};
}

Document check_report(const Deck& deck, const CheckedRun& run) {
    return run.start ? check_report(deck, *run.start, forecast(deck, *run.start, run.execution))
                     : few_body_check_report(deck);
}

}  // namespace ljmd
