#include <OpenMM.h>
#include <openmm/serialization/XmlSerializer.h>

#include <memory>
#include <sstream>
#include "catch.hpp"

#include "compare/openmm.hpp"
#include "compare/small_fluid.hpp"

using namespace ljmd;
using namespace ljmd::test;

namespace {

template <class Object>
std::unique_ptr<Object> read(const std::string& text) {
    std::istringstream stream(text);
    return std::unique_ptr<Object>(OpenMM::XmlSerializer::deserialize<Object>(stream));
}

}  // namespace

TEST_CASE("what is exported continues as the peer does") {
    const Fluid fluid = small_fluid("lennard-jones", "cut", true);
    const OpenmmXml xml = openmm_xml(fluid, 0.004);
    const auto system = read<OpenMM::System>(xml.system);
    const auto state = read<OpenMM::State>(xml.state);
    const auto integrator = read<OpenMM::Integrator>(xml.integrator);
    CHECK(integrator->getStepSize() == 0.004);
    CHECK(system->getNumForces() == 1);
    OpenMM::Context context(*system, *integrator, OpenMM::Platform::getPlatformByName("Reference"));
    context.setState(*state);
    integrator->step(20);
    const OpenMM::State after = context.getState(OpenMM::State::Positions | OpenMM::State::Energy);
    const auto frames = make_openmm_peer(fluid, {})->follow("VerletIntegrator", 0.004, {20});
    for (std::size_t i = 0; i < fluid.positions.size(); ++i) {
        const OpenMM::Vec3& r = after.getPositions()[i];
        CHECK(frames[0].positions[i] == Vec3(r[0], r[1], r[2]));
    }
    const double tail = 3.0 * make_openmm_peer(fluid, {})->point().tail_energy.value();
    CHECK(after.getPotentialEnergy() == Approx(frames[0].potential_energy + tail).epsilon(1e-12));
    CHECK(after.getKineticEnergy() == Approx(frames[0].kinetic_energy).epsilon(1e-14));
}
