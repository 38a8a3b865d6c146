#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ljmd/compare/fluid.hpp"
#include "ljmd/compare/peer.hpp"

namespace ljmd {

/// Whether this build of ljmd has OpenMM in it. Without it every other function here throws InputError.
[[nodiscard]] bool openmm_is_built_in();

/// "7.7", of the library that is loaded; empty without OpenMM.
[[nodiscard]] std::string openmm_version();

/// The fluid in OpenMM, in this process: sigma = 1 nm, epsilon = 1 kJ/mol and m = 1 u make tau = 1 ps exactly.
///
/// Lennard-Jones, cut or switched, is a NonbondedForce without charges; all else a CustomNonbondedForce made from the
/// formula's own expression. The virial is the derivative of the energy with respect to a scale of all distances.
///
/// Methods: VerletIntegrator, which is leapfrog and is given v(-dt/2) = v(0) - F(0) dt/2m with OpenMM's own forces, and
/// a kick-drift-kick CustomIntegrator, which is velocity Verlet.
///
/// @param platform  "Reference", "CPU", "OpenCL", ... of those that are loaded
/// @param threads   of the CPU platform
/// @throws InputError  an unknown platform (the message lists those loaded), one that cannot be used, a cutoff beyond
///                     L/2, a position that is not finite
[[nodiscard]] std::unique_ptr<Peer> make_openmm_peer(const Fluid& fluid, const std::string& platform, int threads);

/// The fluid as OpenMM's XML files, from which its Python continues: a VerletIntegrator, and with it a state that holds
/// v(-dt/2).
struct OpenmmXml {
    std::string system;
    std::string state;
    std::string integrator;
};
/// @throws InputError as make_openmm_peer
[[nodiscard]] OpenmmXml openmm_xml(const Fluid& fluid, double time_step);

}  // namespace ljmd
