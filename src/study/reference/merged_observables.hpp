#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ljmd {

/// An observable in the merged results of replicas.
struct MergedObservable {
    std::string name;
    std::string unit;
    double mean;            ///< NaN if it has no value
    double standard_error;  ///< NaN if unknown
    double independent;     ///< samples; NaN if unknown
    bool converged;         ///< false: the standard error is a guess
    std::string remark;
};

/// All observables in the results.json of a directory of replicas. @throws DataError  it is missing or damaged
[[nodiscard]] std::vector<MergedObservable> merged_observables(const std::filesystem::path& directory);

/// The one with this name; nullptr if there is none or if it has no value.
[[nodiscard]] const MergedObservable* find_merged(const std::vector<MergedObservable>& all, std::string_view name);

}  // namespace ljmd
