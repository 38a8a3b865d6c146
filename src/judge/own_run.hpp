#pragma once

#include "engine/fluid_system.hpp"
#include "judge/exchange.hpp"
#include "judge/frame_judgement.hpp"
#include "judge/row_judgement.hpp"
#include "judge/run_judgement.hpp"
#include "ljmd/detail/run/interruption.hpp"

namespace ljmd {

/// Fill in what ljmd says about the frames of an engine: forces at the engine's positions, and positions, velocities
/// and forces of velocity Verlet from the start, at the steps of the frames.
/// @pre steps ascend  @param execution  for the states
void follow(const Fluid& fluid, ForceField& force_field, const Execution& execution, JudgedTrajectory& trajectory);

/// Forces of ljmd at positions anywhere. @throws PhysicsError  one is not finite
[[nodiscard]] std::vector<Vec3> forces_at(const Fluid& fluid, const std::vector<Vec3>& positions,
                                          ForceField& force_field, const Execution& execution);

/// Energies and pressures of velocity Verlet from the start, at each step from 0 to `steps`.
/// @param tail  its corrections are in them  @param execution  for the state
[[nodiscard]] std::vector<OwnRow> own_rows(const Fluid& fluid, const TailCorrection& tail, ForceField& force_field,
                                           const Execution& execution, double time_step, Index steps);

/// The run of a problem's stage in ljmd, with its thermostat and barostat, sampled every thermo_every steps without the
/// start.
/// @param interruption  asked after every step
/// @throws PhysicsError  as run_stages()  @throws Interrupted
[[nodiscard]] RunSamples own_run(const Problem& problem, const FluidSpec& spec, const Execution& execution,
                                 const Interruption& interruption = Interruption());

/// Keep the rows of two runs that are of the same steps: runs from one start are compared over the same time.
/// @param ours    sampled at `every`, 2 `every`, ...
/// @param theirs  at the last of `steps`, which ascend; as many as it has samples
void keep_common_rows(RunSamples& ours, Index every, RunSamples& theirs, const std::vector<Index>& steps);

/// Kinetic energy of the velocities v + a t: of half a time step earlier or later, if t is that.
[[nodiscard]] double half_step_kinetic_energy(const Fluid& fluid, const std::vector<Vec3>& forces, double t);

}  // namespace ljmd
