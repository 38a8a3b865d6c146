#pragma once

#include <optional>
#include <string>

namespace ljmd {

/// A result that is a single number. Units are the specification's; angles are in rad.
struct Finding {
    std::string name;
    double value;                          ///< NaN if it has none
    std::optional<double> standard_error;  ///< for means over orbits or swings
    std::string remark = {};               ///< why there is no value, or what must be known of it
};

}  // namespace ljmd
