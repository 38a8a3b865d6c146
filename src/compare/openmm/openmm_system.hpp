#pragma once

#include <OpenMM.h>

#include <memory>
#include <vector>

#include "compare/openmm_module.hpp"

namespace ljmd {

// Numbers in OpenMM's units equal those in reduced units: sigma = 1 nm, epsilon = 1 kJ/mol, m = 1 u, tau = 1 ps.

/// Force groups: the force that moves the atoms, and the one used only for its derivative.
inline constexpr int moving_group = 0;
inline constexpr int virial_group = 1;
/// As bit masks for OpenMM's calls.
inline constexpr int moving = 1 << moving_group;
inline constexpr int virial = 1 << virial_group;

/// The name of the parameter whose derivative is minus the virial.
inline constexpr const char* scale_parameter = "scale";

/// Forces besides the one that moves the atoms.
enum class OpenmmForces {
    alone,        ///< nothing
    with_tail,    ///< OpenMM's long-range correction of that force
    with_virial,  ///< a second force for the virial
};

/// Box, masses and forces of a fluid.
/// @param epsilon  see OpenmmOptions
/// @throws InputError see make_openmm_peer
[[nodiscard]] std::unique_ptr<OpenMM::System> openmm_system(const OpenmmFluid& fluid, OpenmmForces forces,
                                                            double epsilon = 1.0);

/// Conversion of vectors for a context.
[[nodiscard]] std::vector<OpenMM::Vec3> openmm_vectors(const std::vector<Vec3>& vectors);
[[nodiscard]] std::vector<Vec3> from_openmm(const std::vector<OpenMM::Vec3>& vectors);

/// v(-dt/2) = v(0) - F(0) dt/2m: the velocities that VerletIntegrator expects at time 0.
/// @param context  at the fluid's positions
[[nodiscard]] std::vector<OpenMM::Vec3> half_step_velocities(OpenMM::Context& context, const Fluid& fluid,
                                                             double time_step);

}  // namespace ljmd
