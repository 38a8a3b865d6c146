#pragma once

#include <string>

#include "ljmd/core/schema.hpp"

namespace ljmd {

/// The key `time`, tau_T, of a canonical thermostat.
/// @param usual    its default [tau]
/// @param meaning  what happens within that time
inline Key relaxation_time(double usual, const std::string& meaning) {
    return Key::number("time")
        .dimension(Dimension::time)
        .unit("tau")
        .above(0.0)
        .defaults_to(usual)
        .meaning("tau_T: " + meaning);
}

}  // namespace ljmd
