#pragma once

#include "deck/deck.hpp"
#include "engine/few_body_system.hpp"
#include "io/tables/few_body_columns.hpp"
#include "io/tables/thermo_columns.hpp"

namespace ljmd {

/// Columns of the history of a fluid: the density if a stage has a barostat, the edges if it changes
/// each by itself, the conserved energy if one has a
/// thermostat that knows it, SI columns for a substance.
/// @param order_parameter  the run starts from a lattice
[[nodiscard]] ThermoColumns thermo_columns(const RunPlan& plan, bool order_parameter,
                                           const ExternalForce* external = nullptr);

/// Columns of the trajectories of few bodies: the polar angle if the force has one, accelerations if the deck asks for
/// them.
[[nodiscard]] TrajectoryColumns trajectory_columns(const RunPlan& plan, const FewBodySystem& system);

}  // namespace ljmd
