#pragma once

#include <string>

#include "ljmd/engine/run_result.hpp"

namespace ljmd {

/// With a translational order above this when sampling begins, the crystal of the start is not gone, and samples are
/// neither of a crystal nor of a liquid: 0.1, or 5 times the scatter (6 N)^(-1/2) of the order of N molten atoms, which
/// is a mean of 3 N cosines. @pre atoms > 0
[[nodiscard]] double largest_molten_order(Index atoms);

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

/// Put remarks on stages and on the temperature, and warnings about the results as a whole.
void add_remarks(RunResult& result, const FluidSpec& spec);

}  // namespace ljmd
