#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// Mean of an observable in a run; NaN if unknown.
struct ObservedMean {
    std::string name;
    double mean;
    double standard_error;
    std::string remark = {};  ///< as in results.json
};

/// A stage of a run, as in results.json.
struct RecordedStage {
    bool sampled;
    Index first_step;
    Index steps;
};

/// The results of a run, as a study reads them.
struct RecordedResults {
    std::vector<ObservedMean> means;  ///< in file order; for few bodies also the results of analyses, "orbit_period"
    std::vector<RecordedStage> stages;
    std::vector<std::string> doubts = {};  ///< see RunResult::doubts
};

/// Read a run's results.json.
/// @throws DataError  the file is missing or damaged, or a run of ljmd cannot have written it
[[nodiscard]] RecordedResults read_results(const std::filesystem::path& path);

}  // namespace ljmd
