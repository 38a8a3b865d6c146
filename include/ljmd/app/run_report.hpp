#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ljmd/app/run.hpp"

namespace ljmd {

// What the reports on runs of a fluid and of a few bodies have in common.

/// The title of a deck, or its path, fit for one line of the screen.
[[nodiscard]] std::string title_line(const Deck& deck);

/// A stage as it stands in results.json.
[[nodiscard]] nlohmann::ordered_json stage_json(const StageResult& stage);

/// Lines about the stages for the table on the screen: the drift of the energy where it should be conserved and, when
/// the motion was turned round, the checksums that tell whether it came back.
[[nodiscard]] std::string stage_lines(const std::vector<StageResult>& stages, const std::string& drift_unit);

}  // namespace ljmd
