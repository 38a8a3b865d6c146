#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ljmd {

/// What a run says of an observable; NaN where it says nothing.
struct ObservedMean {
    std::string name;
    double mean;
    double standard_error;
    std::string remark = {};  ///< as in results.json
};

/// The observables in a run's results.json, in its order; of few bodies also what analyses found, "orbit_period".
/// @throws DataError  it is not there, or damaged
[[nodiscard]] std::vector<ObservedMean> observed_means(const std::filesystem::path& results);

/// A point of a sweep that is at its end.
struct SweptPoint {
    std::string name;
    std::vector<std::string> values;  ///< of the varied keys
    std::filesystem::path directory;
    std::vector<ObservedMean> found;  ///< nothing when it has failed
    std::string failure;              ///< why; empty when it has not
};

/// What a sweep has found.
struct SweptPoints {
    std::vector<std::string> keys;
    std::vector<SweptPoint> points;
};

// The table of `ljmd sweep`, in three forms.

/// For people, as it ends on the screen: values of the keys, and T, U, p and Z, or of few bodies their energies; below
/// them the remarks that numbers are marked with.
[[nodiscard]] std::string sweep_table(const SweptPoints& swept);

/// sweep.csv: the varied keys, then each observable and its `_standard_error`; empty where there is none. Last,
/// `remarks`: "NAME: remark", separated by "; ".
[[nodiscard]] std::string sweep_csv(const SweptPoints& swept);

[[nodiscard]] std::string sweep_json(const SweptPoints& swept);

/// The table's observables of one point, in a line: "T 1.2034 +- 0.0012, U/N ...".
[[nodiscard]] std::string point_line(const SweptPoint& point);

}  // namespace ljmd
