#pragma once

#include <optional>
#include <string>

#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// An observable of a run: its mean over the sampled stages, with its error.
struct ObservableAverage {
    std::string name;                  ///< as in results.json
    std::string symbol;                ///< for tables
    std::string unit;                  ///< reduced, e.g. "epsilon/k_B"
    std::optional<Estimate> estimate;  ///< empty if the observable has no value (temperature of one atom)
    std::string remark = {};           ///< note for the reader: why there is no value, or why to doubt it
};

}  // namespace ljmd
