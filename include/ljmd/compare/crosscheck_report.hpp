#pragma once

#include <filesystem>
#include <string>

#include "ljmd/compare/crosscheck.hpp"

namespace ljmd {

/// What was found, for the screen: every check, the trajectories in a table, averages side by side, speeds, verdict.
[[nodiscard]] std::string crosscheck_table(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options);

/// {"checks": [{"name", "value", "tolerance", "passed"}, ...], "passed", ...}; see docs/crosscheck.md.
[[nodiscard]] std::string crosscheck_json(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options);

/// compare-WITH.json, compare-WITH-trajectory.csv and compare-WITH-rdf.csv in a directory, which is made if it is not
/// there; the tables if there is anything in them. @throws FileError
void write_crosscheck(const Crosscheck& found, const Deck& deck, const CrosscheckOptions& options,
                      const std::filesystem::path& directory);

}  // namespace ljmd
