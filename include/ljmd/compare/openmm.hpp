#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ljmd/compare/fluid.hpp"
#include "ljmd/compare/peer.hpp"

namespace ljmd {

/// Whether this build of ljmd has OpenMM in it. Without it, make_openmm_peer and openmm_xml throw InputError.
[[nodiscard]] bool openmm_is_built_in();

/// "7.7", of the library that is loaded; empty without OpenMM.
[[nodiscard]] std::string openmm_version();

/// The platforms that are loaded: "Reference", and those of the plug-in folder, which is the one that the environment's
/// OPENMM_PLUGIN_DIR names or else the one found when ljmd was built.
[[nodiscard]] std::vector<std::string> openmm_platforms();

struct OpenmmOptions {
    std::string platform = "Reference";
    int threads = 1;  ///< of the CPU platform
    /// The unit of energy of the fluid [kJ/mol]. Only a test that wants the two to differ sets anything but 1.
    double epsilon = 1.0;
};

/// The fluid in OpenMM, in this process: sigma = 1 nm, epsilon = 1 kJ/mol and m = 1 u make tau = 1 ps exactly.
///
/// Lennard-Jones, cut or switched, is a NonbondedForce without charges; all else a CustomNonbondedForce made from the
/// formula's expression. The virial is W = -dU(s r)/ds at s = 1, for a scale s of all distances, cutoff left alone.
///
/// Methods: "VerletIntegrator", which is leapfrog and is given v(-dt/2) = v(0) - F(0) dt/2m with OpenMM's own forces,
/// and "kick-drift-kick", a CustomIntegrator that is velocity Verlet.
///
/// Source: Eastman et al. (2017), doi:10.1371/journal.pcbi.1005659, and OpenMM's user guide, sections 17 to 19
///
/// @throws InputError    an unknown platform (the message lists those loaded), one that cannot be used, a cutoff beyond
///                       L/2, a position that is not finite
/// @throws PhysicsError  from the peer, when OpenMM gives up
[[nodiscard]] std::unique_ptr<Peer> make_openmm_peer(const Fluid& fluid, const OpenmmOptions& options);

/// The fluid as OpenMM's XML files, from which its Python continues: a VerletIntegrator, and with it a state that holds
/// v(-dt/2). Positions in nm are those in sigma, and so on, as above.
struct OpenmmXml {
    std::string system;
    std::string state;
    std::string integrator;
};
/// @throws InputError as make_openmm_peer
[[nodiscard]] OpenmmXml openmm_xml(const Fluid& fluid, double time_step);

}  // namespace ljmd
