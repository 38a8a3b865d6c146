#pragma once

#include <string>
#include <vector>

#include "ljmd/core/data.hpp"
#include "ljmd/run/run.hpp"

namespace ljmd {

// Common to the reports on runs of a fluid and of a few bodies.

/// The title of a deck, or its path, as one line of the screen.
[[nodiscard]] std::string title_line(const Deck& deck);

/// The remark on a large energy drift in a stage of a fluid; empty if the drift is small, or undefined. It is large if
/// it adds up to more than 0.3 % of the kinetic energy (2 % in less than 5 tau): the samples then belong to no single
/// energy, and a time step that heats the fluid so much also falsifies temperature and pressure.
/// @param kinetic_energy  per atom, mean over the sampled stages
[[nodiscard]] std::string drift_remark(const StageResult& stage, double kinetic_energy);

/// The remark on a time step that is too long in a sampled stage of a fluid; empty if it is short enough, and for
/// integrators of higher than second order. It is too long if it makes the temperatures of velocities and of
/// configurations differ by more than 1 % (see TimeStepError): the pressure of a liquid is then off by several
/// hundredths, even if the energy does not drift.
[[nodiscard]] std::string time_step_remark(const StageResult& stage);

/// A stage in results.json.
[[nodiscard]] Data stage_data(const StageResult& stage);

/// Lines about the stages for the table on the screen: the energy drift where energy should be conserved, time steps
/// that are too long and, after a reversal, the checksums that show whether the motion came back.
[[nodiscard]] std::string stage_lines(const std::vector<StageResult>& stages, const std::string& drift_unit);

}  // namespace ljmd
