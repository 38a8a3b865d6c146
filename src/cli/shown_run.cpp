#include "cli/shown_run.hpp"

#include <fmt/format.h>

#include "cli/streams.hpp"
#include "report/written_report.hpp"

namespace ljmd {

void show_run(const Deck& deck, Progress& progress, bool as_json, const std::function<Document()>& run) {
    // Doubts about results stand below the table, too: where both are read, there alone.
    if (!as_json && messages_stand_beside_results()) {
        progress.leave_doubts_to_report();
    }
    const Document results = run();
    progress.clear_line();
    print_document(results, as_json);
    if (const auto page = write_asked_report(deck, warn)) {
        print_message(fmt::format("report: {}\n", page->string()));
    }
}

}  // namespace ljmd
