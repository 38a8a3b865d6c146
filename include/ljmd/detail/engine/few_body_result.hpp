#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/observables/few_body/finding.hpp"
#include "ljmd/engine/run_result.hpp"

namespace ljmd {

/// History of a total of the system; conserved totals show the error of the integrator.
struct FewBodyHistory {
    std::string name;
    double at_start;
    double at_end;
    double mean;               ///< over the samples
    double largest_deviation;  ///< from the start, over the samples

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
    std::vector<DataTable> tables;                                       ///< of the analyses
    double seconds;                                                      ///< wall time of the time loop
};

}  // namespace ljmd
