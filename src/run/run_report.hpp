#pragma once

#include <string>
#include <vector>

#include "deck/deck.hpp"
#include "ljmd/detail/core/data.hpp"
#include "ljmd/engine/run_result.hpp"

namespace ljmd {

// Common to the reports on runs of a fluid and of a few bodies.

/// The title of a deck, or its path, in lines that fit the screen.
[[nodiscard]] std::string title_line(const RunPlan& plan);

/// A stage in results.json.
[[nodiscard]] Data stage_data(const StageResult& stage);

/// Lines about the stages for the table on the screen: the energy drift where energy should be conserved and, after a
/// reversal, the checksums that show whether the motion came back.
[[nodiscard]] std::string stage_lines(const std::vector<StageResult>& stages, const std::string& drift_unit);

}  // namespace ljmd
