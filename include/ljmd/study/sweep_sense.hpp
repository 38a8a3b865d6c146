#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/study/sweep_points.hpp"

namespace ljmd {

/// Load the deck with the settings of every point, and report what is wrong with it and what is to be warned of. The
/// file that a point starts from is read.
///
/// Mistakes of several points that differ in nothing but numbers are reported once, as the first of them, with the
/// points: "... (temperature=0.5,density=2, temperature=1,density=2 and 3 other points)". One that stands in a varied
/// key is located in "--grid KEY" or "--list KEY".
/// @param deck      name and text
/// @param settings  of --set, before those of a point
/// @param option    that gave the points: "--grid" or "--list"
/// @param force     accept what is unlikely, see check_sense()
void check_points(const Source& deck, const std::vector<std::string>& settings, const SweepPoints& points,
                  const std::string& option, bool force, Diagnostics& diagnostics);

}  // namespace ljmd
