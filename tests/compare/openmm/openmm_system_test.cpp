#include "compare/openmm/openmm_system.hpp"

#include <limits>
#include "catch.hpp"

#include "compare/small_fluid.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

template <class Force>
const Force* force_of(const OpenMM::System& system, int index) {
    return dynamic_cast<const Force*>(&system.getForce(index));
}

OpenmmFluid told(const std::string& formula, const std::string& truncation) {
    return openmm_fluid(small_fluid(formula, truncation));
}

}  // namespace

TEST_CASE("box and masses of a fluid are those of its system") {
    Fluid fluid = small_fluid();
    fluid.masses = {1.0, 2.0, 3.0};
    const auto system = openmm_system(openmm_fluid(fluid), OpenmmForces::alone);
    OpenMM::Vec3 a;
    OpenMM::Vec3 b;
    OpenMM::Vec3 c;
    system->getDefaultPeriodicBoxVectors(a, b, c);
    CHECK(a[0] == 6.0);
    CHECK(b[1] == 7.0);
    CHECK(c[2] == 8.0);
    REQUIRE(system->getNumParticles() == 3);
    CHECK(system->getParticleMass(2) == 3.0);
}

TEST_CASE("Lennard-Jones, cut or switched, is a NonbondedForce with what differs set") {
    const auto cut = openmm_system(told("lennard-jones", "cut"), OpenmmForces::alone);
    REQUIRE(cut->getNumForces() == 1);
    const auto* force = force_of<OpenMM::NonbondedForce>(*cut, 0);
    REQUIRE(force != nullptr);
    CHECK(force->getNonbondedMethod() == OpenMM::NonbondedForce::CutoffPeriodic);
    CHECK(force->getCutoffDistance() == 2.5);
    CHECK_FALSE(force->getUseSwitchingFunction());
    CHECK_FALSE(force->getUseDispersionCorrection());

    const auto switched = openmm_system(told("lennard-jones", "switched"), OpenmmForces::with_virial);
    REQUIRE(switched->getNumForces() == 2);
    force = force_of<OpenMM::NonbondedForce>(*switched, 0);
    REQUIRE(force != nullptr);
    CHECK(force->getUseSwitchingFunction());
    CHECK(force->getSwitchingDistance() == 2.0);
    CHECK_FALSE(force->getUseDispersionCorrection());
    const auto* derivative = force_of<OpenMM::CustomNonbondedForce>(*switched, 1);
    REQUIRE(derivative != nullptr);
    CHECK(derivative->getForceGroup() == virial_group);
    CHECK_FALSE(derivative->getUseLongRangeCorrection());

    const auto with_tail = openmm_system(told("lennard-jones", "cut"), OpenmmForces::with_tail);
    REQUIRE(with_tail->getNumForces() == 1);
    CHECK(force_of<OpenMM::NonbondedForce>(*with_tail, 0)->getUseDispersionCorrection());
}

TEST_CASE("every other potential is a custom force") {
    for (const auto& [formula, truncation] : {std::pair{"lennard-jones", "shifted"},
                                              {"lennard-jones", "force-shifted"},
                                              {"morse", "cut"},
                                              {"morse", "switched"}}) {
        const auto system = openmm_system(told(formula, truncation), OpenmmForces::alone);
        CHECK(force_of<OpenMM::CustomNonbondedForce>(*system, 0) != nullptr);
    }
}

TEST_CASE("positions that are not finite and a cutoff beyond half the box are refused") {
    Fluid fluid = small_fluid();
    fluid.positions[1][2] = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(openmm_system(openmm_fluid(fluid), OpenmmForces::alone), InputError);
    CHECK_THROWS_WITH(openmm_system(openmm_fluid(fluid), OpenmmForces::alone), Contains("atom 2 is not finite"));
    fluid = small_fluid();
    fluid.velocities[0][0] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH(openmm_system(openmm_fluid(fluid), OpenmmForces::alone), Contains("atom 1 is not finite"));
    fluid = small_fluid();
    fluid.edges = Vec3(6.0, 4.9, 8.0);
    CHECK_THROWS_WITH(openmm_system(openmm_fluid(fluid), OpenmmForces::alone),
                      Contains("the cutoff 2.5 is beyond half the shortest edge of the box"));
}

TEST_CASE("vectors survive the way to OpenMM and back") {
    const std::vector<Vec3> vectors{{1.0, 2.0, 3.0}, {-0.1, 1e-300, 7.0}};
    CHECK(from_openmm(openmm_vectors(vectors)) == vectors);
}

TEST_CASE("velocities of the half step before are shifted by OpenMM's own forces") {
    const Fluid fluid = small_fluid();
    const auto system = openmm_system(openmm_fluid(fluid), OpenmmForces::with_virial);
    OpenMM::VerletIntegrator integrator(0.004);
    OpenMM::Context context(*system, integrator, OpenMM::Platform::getPlatformByName("Reference"));
    context.setPositions(openmm_vectors(fluid.positions));
    const auto forces = context.getState(OpenMM::State::Forces, false, moving).getForces();
    const auto shifted = half_step_velocities(context, fluid, 0.004);
    REQUIRE(forces[0][0] != 0.0);
    CHECK(shifted[0][0] == Approx(fluid.velocities[0][0] - 0.002 * forces[0][0]).epsilon(1e-15));
}
