#pragma once

#include <optional>
#include <string>

#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// One observable of a run: its mean over the sampled stages and how well it is known.
struct ObservableAverage {
    std::string name;                  ///< as in results.json
    std::string symbol;                ///< for tables
    std::string unit;                  ///< reduced, e.g. "epsilon/k_B"
    std::optional<Estimate> estimate;  ///< empty where the observable has no value (temperature of one atom)
    std::string remark = {};           ///< what a reader has to know of it: why it has no value, why to doubt it
};

}  // namespace ljmd
