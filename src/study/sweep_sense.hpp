#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ljmd/detail/options/diagnostics.hpp"
#include "study/sweep_points.hpp"

namespace ljmd {

/// Load the deck with the settings of every point, and report errors and warnings. The start file of a point is read.
///
/// Mistakes of several points that differ only in numbers are reported once, in the words of the first, with the names
/// of points: "... (temperature=0.5,density=2; temperature=1,density=2; temperature=2,density=2 and 3 other points)". A
/// mistake in a varied key is located in "--grid KEY" or "--list KEY".
/// @param deck      name and text
/// @param settings  arguments of --set, applied before a point's own
/// @param option    that gave the points: "--grid" or "--list"
/// @param force     accept unlikely values, see check_sense()
void check_points(const Source& deck, const std::vector<std::string>& settings, const SweepPoints& points,
                  const std::string& option, bool force, Diagnostics& diagnostics);

}  // namespace ljmd
