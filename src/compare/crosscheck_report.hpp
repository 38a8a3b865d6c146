#pragma once

#include <filesystem>
#include <string>

#include "compare/crosscheck.hpp"
#include "ljmd/detail/core/data.hpp"

namespace ljmd {

/// Checks as a table, and as a list of {"name", "value", "tolerance", "passed"}.
[[nodiscard]] std::string check_lines(const std::vector<Check>& checks);
[[nodiscard]] Data checks_data(const std::vector<Check>& checks);

/// Report for the screen: checks, divergence of trajectories, averages side by side, speeds, verdict.
[[nodiscard]] std::string crosscheck_table(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options);

/// {"checks": [{"name", "value", "tolerance", "passed"}, ...], "passed", ...}; see docs/crosscheck.md.
[[nodiscard]] std::string crosscheck_json(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options);

/// Write compare-WITH.json, compare-WITH-trajectory.csv and compare-WITH-rdf.csv into a directory, creating it if
/// needed; tables without rows are not written.
/// @param force  whether existing files of these names are replaced
/// @throws OutputRefused as require_writable(); FileError
void write_crosscheck(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options,
                      const std::filesystem::path& directory, bool force = false);

}  // namespace ljmd
