#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ljmd/run/run.hpp"

namespace ljmd {

// What the reports on runs of a fluid and of a few bodies have in common.

/// The title of a deck, or its path, fit for one line of the screen.
[[nodiscard]] std::string title_line(const Deck& deck);

/// What is wrong with the drift of the energy in a stage of a fluid; empty where it is small, or where there is none.
/// It is large when it adds up to more than 0.3 % of the kinetic energy (2 % in less than 5 tau): then what is measured
/// belongs to no one energy, and a time step that heats the fluid so much falsifies temperature and pressure as well.
/// @param kinetic_energy  per atom, mean over the sampled stages
[[nodiscard]] std::string drift_remark(const StageResult& stage, double kinetic_energy);

/// What is wrong with the time step of a sampled stage of a fluid; empty where it is short enough, and for integrators
/// of higher than second order. It is too long when it sets the temperatures of velocities and of configurations apart
/// by more than 1 % (see TimeStepError): the pressure of a liquid is then off by several hundredths, while the energy
/// need not drift.
[[nodiscard]] std::string time_step_remark(const StageResult& stage);

/// A stage as it stands in results.json.
[[nodiscard]] nlohmann::ordered_json stage_json(const StageResult& stage);

/// Lines about the stages for the table on the screen: the drift of the energy where it should be conserved, time steps
/// that are too long and, when the motion was turned round, the checksums that tell whether it came back.
[[nodiscard]] std::string stage_lines(const std::vector<StageResult>& stages, const std::string& drift_unit);

}  // namespace ljmd
