#include <OpenMM.h>
#include <openmm/serialization/XmlSerializer.h>

#include <sstream>

#include "compare/openmm/linked_openmm.hpp"
#include "compare/openmm/openmm_system.hpp"

namespace ljmd {

namespace {

template <class Object>
std::string xml(const Object& object, const std::string& root) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    OpenMM::XmlSerializer::serialize<Object>(&object, root, stream);
    return stream.str();
}

}  // namespace

OpenmmXml linked_openmm_xml(const OpenmmFluid& fluid, double time_step) {
    const auto system = openmm_system(fluid, fluid.tail ? OpenmmForces::with_tail : OpenmmForces::alone);
    OpenMM::VerletIntegrator integrator(time_step);
    OpenMM::Context context(*system, integrator, OpenMM::Platform::getPlatformByName("Reference"));
    context.setPositions(openmm_vectors(fluid.positions));
    context.setVelocities(half_step_velocities(context, fluid, time_step));
    const OpenMM::State state =
        context.getState(OpenMM::State::Positions | OpenMM::State::Velocities | OpenMM::State::Parameters);
    return {xml(*system, "System"), xml(state, "State"), xml<OpenMM::Integrator>(integrator, "Integrator")};
}

}  // namespace ljmd
