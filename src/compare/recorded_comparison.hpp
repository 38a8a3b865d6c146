#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/document.hpp"

namespace ljmd {

/// Whether a file of this name has the results of a comparison.
[[nodiscard]] bool is_comparison_result(const std::string& name);

/// The results of comparisons in a directory, as `ljmd compare --out` writes them: compare-openmm.json, judge.json.
/// Sorted; empty if there are none. @throws FileError  the directory cannot be read
[[nodiscard]] std::vector<std::filesystem::path> comparison_results(const std::filesystem::path& directory);

/// Whether a path is a directory with comparisons.
[[nodiscard]] bool holds_comparison(const std::filesystem::path& directory);

/// What `ljmd info` says of a directory with comparisons: of each its deck, the other program, the verdict, failed
/// checks and diagnoses. Data: kind "comparison", comparisons with file, deck, with, peer, checks (their number),
/// failed (names), passed, diagnoses.
/// @throws DataError  there is none, or it is damaged
[[nodiscard]] Document comparison_report(const std::filesystem::path& directory);

}  // namespace ljmd
