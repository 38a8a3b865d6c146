#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "run/recorded_results.hpp"

namespace ljmd {

/// A completed point of a sweep.
struct SweptPoint {
    std::string name;
    std::vector<std::string> values;  ///< of the varied keys
    std::filesystem::path directory;
    std::vector<ObservedMean> found;       ///< empty if it failed
    std::string failure;                   ///< reason of the failure; empty if it succeeded
    std::vector<std::string> doubts = {};  ///< about the run, see RunResult::doubts
};

/// Results of a sweep.
struct SweptPoints {
    std::vector<std::string> keys;
    std::vector<SweptPoint> points;
};

/// The results of `ljmd sweep`. Text: a table with values of the keys, then T, U, p and Z, or the energies of few
/// bodies, and the mark of what is doubtful about the run; below it the remarks. Data: keys; points with name,
/// directory, values, failure or null, doubts, observables.
/// @param screen  columns of the terminal that the table has to fit: errors are written shorter, then observables are
/// left out from the last on, which is said below. None: the whole table
[[nodiscard]] Document sweep_report(const SweptPoints& swept, std::optional<std::size_t> screen = std::nullopt);

/// sweep.csv: the varied keys, then each observable and its `_standard_error`, empty if unknown. The last column is
/// `remarks`: "NAME: remark", then the doubts about the run, separated by "; ".
[[nodiscard]] std::string sweep_csv(const SweptPoints& swept);

/// The table's observables of one point as a line: "T 1.2034 +- 0.0012, U/N ...".
[[nodiscard]] std::string point_line(const SweptPoint& point);

}  // namespace ljmd
