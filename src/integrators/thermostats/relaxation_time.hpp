#pragma once

#include <string>

#include "ljmd/detail/options/description.hpp"

namespace ljmd {

/// The key `time` of a canonical thermostat, tau_T [tau].
/// @param meaning  what it is the time of
inline void describe_relaxation_time(Description& description, double& time, const std::string& meaning) {
    description.number("time", time).dimension(Dimension::time).unit("tau").above(0.0).meaning("tau_T: " + meaning);
}

}  // namespace ljmd
