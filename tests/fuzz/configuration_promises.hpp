#pragma once

#include <algorithm>

#include "deck/fluid.hpp"
#include "fuzz_target.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/model/configuration.hpp"

namespace ljmd::fuzz {

/// A configuration that was read is what Configuration says, and a run can start from it.
inline void check_promises(const Configuration& configuration) {
    const auto finite = [](const Vec3& v) { return v.allFinite(); };
    const auto& [edges, positions, velocities, masses, time, step, is_unwrapped, remarks] = configuration;
    require(!positions.empty(), "a configuration has no atoms");
    require(velocities.empty() || velocities.size() == positions.size(), "not every atom has a velocity");
    require(masses.empty() || masses.size() == positions.size(), "not every atom has a mass");
    require(std::all_of(positions.begin(), positions.end(), finite), "a position is not finite");
    require(std::all_of(velocities.begin(), velocities.end(), finite), "a velocity is not finite");
    require(std::all_of(masses.begin(), masses.end(), [](double m) { return std::isfinite(m) && m > 0.0; }),
            "a mass is not finite and positive");
    require(!time || std::isfinite(*time), "the time is not finite");
    State state(static_cast<Index>(positions.size()), Box(edges));
    try {
        place_configuration(state, configuration);
    } catch (const DataError&) {  // a mass that is not 1
    }
    ++inputs_accepted;
}

}  // namespace ljmd::fuzz
