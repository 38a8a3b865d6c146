#pragma once

#include <set>

#include "fuzz_target.hpp"
#include "study/sweep_points.hpp"

namespace ljmd::fuzz {

/// What holds of the points of a sweep, whatever they were read from.
inline void check_points(const SweepPoints& points) {
    require(!points.values.empty() && points.values.size() <= max_points, "no more points than are allowed");
    ++inputs_accepted;
    for (std::size_t point = 0; point < points.values.size(); ++point) {
        require(points.values[point].size() == points.keys.size(), "a value for each key");
        for (const std::string& value : points.values[point]) {
            require(!value.empty(), "no empty value");
        }
        require(point_settings(points, point).size() == points.keys.size(), "a setting for each key");
    }
    std::set<std::string> names;
    for (const std::string& name : point_names(points)) {
        require(names.insert(name).second, "a name of its own for each point");
        require(name.find('/') == std::string::npos && name.size() < 250, "names that directories can have");
    }
}

/// What holds of them when mistakes are told of one by one.
inline void check_promises(const SweepPoints& points, const Diagnostics& diagnostics) {
    require(points.values.empty() == diagnostics.has_errors(), "either points or errors");
    if (!points.values.empty()) {
        check_points(points);
        return;
    }
    for (const Diagnostic& entry : diagnostics.entries()) {
        static_cast<void>(format(entry));
    }
}

}  // namespace ljmd::fuzz
