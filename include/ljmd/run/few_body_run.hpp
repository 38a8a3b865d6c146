#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ljmd/deck/few_body.hpp"
#include "ljmd/run/run.hpp"

namespace ljmd {

/// History of a total of the system; conserved totals show the error of the integrator.
struct FewBodyHistory {
    std::string name;
    double at_start;
    double at_end;
    double mean;               ///< over the rows of thermo.csv
    double largest_deviation;  ///< from the start, over the same rows

    void archive(Archive& a) { a(name, at_start, at_end, mean, largest_deviation); }
};

/// Results of a few-body run.
struct FewBodyResult {
    Index bodies;
    int dimensions;
    std::string force;
    std::vector<FewBodyHistory> histories;
    std::vector<StageResult> stages;
    std::vector<std::pair<std::string, std::vector<Finding>>> findings;  ///< of each analysis
    double seconds;                                                      ///< wall time of the time loop
};

/// Run all stages of a few-body deck and write its output directory (see docs/files.md).
///
/// @pre  the output directory exists and has no earlier outputs, or it is that of the resumed run
/// @throws PhysicsError, FileError, CheckpointError, Interrupted; files written until then stay
FewBodyResult run_few_body(const Deck& deck, FewBodySystem& system, RunListener& listener,
                           const RunControl& control = {});

/// results.json and the table on the screen.
[[nodiscard]] std::string few_body_results_json(const Deck& deck, const FewBodyResult& result);
[[nodiscard]] std::string few_body_results_table(const Deck& deck, const FewBodyResult& result);

}  // namespace ljmd
