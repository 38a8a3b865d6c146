#pragma once

#include <string>

#include "ljmd/core/schema.hpp"

namespace ljmd {

/// The key `time` of a canonical thermostat, tau_T.
/// @param usual    its default [tau]
/// @param meaning  what happens in that time
inline Key relaxation_time(double usual, const std::string& meaning) {
    return Key::number("time")
        .dimension(Dimension::time)
        .unit("tau")
        .above(0.0)
        .defaults_to(usual)
        .meaning("tau_T: " + meaning);
}

}  // namespace ljmd
