#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ljmd {

/// Mean of an observable in a run; NaN if unknown.
struct ObservedMean {
    std::string name;
    double mean;
    double standard_error;
    std::string remark = {};  ///< as in results.json
};

/// The observables in a run's results.json, in file order; for few bodies also the results of analyses, "orbit_period".
/// @throws DataError  the file is missing or damaged
[[nodiscard]] std::vector<ObservedMean> observed_means(const std::filesystem::path& results);

/// A completed point of a sweep.
struct SweptPoint {
    std::string name;
    std::vector<std::string> values;  ///< of the varied keys
    std::filesystem::path directory;
    std::vector<ObservedMean> found;  ///< empty if it failed
    std::string failure;              ///< reason of the failure; empty if it succeeded
};

/// Results of a sweep.
struct SweptPoints {
    std::vector<std::string> keys;
    std::vector<SweptPoint> points;
};

// The table of `ljmd sweep` in three formats.

/// Table for the screen: values of the keys, then T, U, p and Z, or the energies of few bodies; below it the remarks.
[[nodiscard]] std::string sweep_table(const SweptPoints& swept);

/// sweep.csv: the varied keys, then each observable and its `_standard_error`, empty if unknown. The last column is
/// `remarks`: "NAME: remark", separated by "; ".
[[nodiscard]] std::string sweep_csv(const SweptPoints& swept);

[[nodiscard]] std::string sweep_json(const SweptPoints& swept);

/// The table's observables of one point as a line: "T 1.2034 +- 0.0012, U/N ...".
[[nodiscard]] std::string point_line(const SweptPoint& point);

}  // namespace ljmd
