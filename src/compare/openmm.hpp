#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "compare/fluid.hpp"
#include "compare/peer.hpp"

namespace ljmd {

/// Where the part of the program for OpenMM is, or would be. All that follows loads it, and throws InputError where it
/// is not there or cannot be loaded.
[[nodiscard]] std::filesystem::path openmm_module();
[[nodiscard]] bool openmm_is_built_in();

/// Version of the loaded library, "7.7".
[[nodiscard]] std::string openmm_version();

/// The loaded platforms: "Reference", and those from the plug-in folder. The folder is named by the environment
/// variable OPENMM_PLUGIN_DIR, or was found when ljmd was built.
[[nodiscard]] std::vector<std::string> openmm_platforms();

struct OpenmmOptions {
    std::string platform = "Reference";
    int threads = 1;  ///< of the CPU platform
    /// Unit of energy of the fluid [kJ/mol]. Other values than 1 are for tests that need a deliberate difference.
    double epsilon = 1.0;
};

/// The fluid in OpenMM, in this process. With sigma = 1 nm, epsilon = 1 kJ/mol and m = 1 u, tau is exactly 1 ps.
///
/// Lennard-Jones, cut or switched, is a NonbondedForce without charges; any other potential is a CustomNonbondedForce
/// with the expression of its formula. The virial is W = -dU(s r)/ds at s = 1, where s scales all distances but not the
/// cutoff.
///
/// Methods: "VerletIntegrator", a leapfrog scheme that starts from v(-dt/2) = v(0) - F(0) dt/2m with OpenMM's own
/// forces, and "kick-drift-kick", velocity Verlet as a CustomIntegrator.
///
/// Source: Eastman et al. (2017), doi:10.1371/journal.pcbi.1005659, and OpenMM's user guide, sections 17 to 19
///
/// @throws InputError    an unknown platform (the message lists those loaded) or an unusable one, a cutoff beyond L/2,
/// a position or velocity that is not finite
/// @throws PhysicsError  from the peer, when OpenMM fails
[[nodiscard]] std::unique_ptr<Peer> make_openmm_peer(const Fluid& fluid, const OpenmmOptions& options);

/// The fluid as XML files of OpenMM, to be continued in its Python interface: a VerletIntegrator, and a state with
/// v(-dt/2). Positions in nm equal those in sigma, and so on, as above.
struct OpenmmXml {
    std::string system;
    std::string state;
    std::string integrator;
};
/// @throws InputError as make_openmm_peer
[[nodiscard]] OpenmmXml openmm_xml(const Fluid& fluid, double time_step);

}  // namespace ljmd
