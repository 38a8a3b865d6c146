#include "compare/openmm/openmm_system.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

void check(const Fluid& fluid) {
    for (std::size_t i = 0; i < fluid.positions.size(); ++i) {
        // The Reference platform does not report numbers that are not finite.
        if (!fluid.positions[i].allFinite() || !fluid.velocities[i].allFinite()) {
            throw InputError(fmt::format("position or velocity of atom {} is not finite", i + 1));
        }
    }
    const double largest = 0.5 * fluid.edges.minCoeff();
    const double cutoff = fluid.potential.cutoff().radius;
    if (cutoff > largest) {
        throw InputError(fmt::format("the cutoff {} is beyond half the shortest edge of the box, {}", cutoff, largest));
    }
}

/// Lennard-Jones as commonly used in OpenMM.
std::unique_ptr<OpenMM::Force> nonbonded_force(const Fluid& fluid, bool tail, double epsilon) {
    auto force = std::make_unique<OpenMM::NonbondedForce>();
    force->setNonbondedMethod(OpenMM::NonbondedForce::CutoffPeriodic);
    force->setCutoffDistance(fluid.potential.cutoff().radius);
    if (fluid.potential.truncation() == "switched") {
        force->setUseSwitchingFunction(true);
        force->setSwitchingDistance(fluid.potential.cutoff().switch_start);
    }
    force->setUseDispersionCorrection(tail);
    for (std::size_t i = 0; i < fluid.masses.size(); ++i) {
        force->addParticle(0.0, 1.0, epsilon);
    }
    return force;
}

/// Any potential by its expression, truncated or not.
std::unique_ptr<OpenMM::CustomNonbondedForce> custom_force(const OpenmmFluid& fluid, const std::string& expression,
                                                           double epsilon) {
    const Cutoff& cutoff = fluid.potential.cutoff();
    auto force =
        std::make_unique<OpenMM::CustomNonbondedForce>(fmt::format("{:.17g}*energy; energy={}", epsilon, expression));
    force->setNonbondedMethod(OpenMM::CustomNonbondedForce::CutoffPeriodic);
    force->setCutoffDistance(cutoff.radius);
    force->addGlobalParameter(scale_parameter, 1.0);
    force->addGlobalParameter("cutoff", cutoff.radius);
    force->addGlobalParameter("switch_start", cutoff.switch_start);
    force->addGlobalParameter("u_cutoff", fluid.at_cutoff.u);
    force->addGlobalParameter("f_cutoff", fluid.at_cutoff.w * cutoff.radius);
    for (const auto& [name, value] : fluid.potential.parameters()) {
        force->addGlobalParameter(name, value);
    }
    for (std::size_t i = 0; i < fluid.masses.size(); ++i) {
        force->addParticle();
    }
    return force;
}

std::unique_ptr<OpenMM::Force> moving_force(const OpenmmFluid& fluid, bool tail, double epsilon) {
    const std::string& truncation = fluid.potential.truncation();
    if (fluid.potential.formula() == "lennard-jones" && (truncation == "cut" || truncation == "switched")) {
        return nonbonded_force(fluid, tail, epsilon);
    }
    // OpenMM's own switch, because its long-range correction supports no other.
    const bool switched = truncation == "switched";
    auto force = custom_force(fluid, switched ? fluid.formula : fluid.expression, epsilon);
    if (switched) {
        force->setUseSwitchingFunction(true);
        force->setSwitchingDistance(fluid.potential.cutoff().switch_start);
    }
    force->setUseLongRangeCorrection(tail);
    return force;
}

}  // namespace

std::unique_ptr<OpenMM::System> openmm_system(const OpenmmFluid& fluid, OpenmmForces forces, double epsilon) {
    check(fluid);
    auto system = std::make_unique<OpenMM::System>();
    system->setDefaultPeriodicBoxVectors({fluid.edges[0], 0.0, 0.0}, {0.0, fluid.edges[1], 0.0},
                                         {0.0, 0.0, fluid.edges[2]});
    for (const double mass : fluid.masses) {
        system->addParticle(mass);
    }
    auto force = moving_force(fluid, forces == OpenmmForces::with_tail, epsilon);
    force->setForceGroup(moving_group);
    system->addForce(force.release());
    if (forces == OpenmmForces::with_virial) {
        auto derivative = custom_force(fluid, fluid.expression, epsilon);
        derivative->addEnergyParameterDerivative(scale_parameter);
        derivative->setForceGroup(virial_group);
        system->addForce(derivative.release());
    }
    return system;
}

std::vector<OpenMM::Vec3> openmm_vectors(const std::vector<Vec3>& vectors) {
    std::vector<OpenMM::Vec3> result;
    result.reserve(vectors.size());
    for (const Vec3& v : vectors) {
        result.emplace_back(v[0], v[1], v[2]);
    }
    return result;
}

std::vector<Vec3> from_openmm(const std::vector<OpenMM::Vec3>& vectors) {
    std::vector<Vec3> result;
    result.reserve(vectors.size());
    for (const OpenMM::Vec3& v : vectors) {
        result.emplace_back(v[0], v[1], v[2]);
    }
    return result;
}

std::vector<OpenMM::Vec3> half_step_velocities(OpenMM::Context& context, const Fluid& fluid, double time_step) {
    const std::vector<OpenMM::Vec3> forces = context.getState(OpenMM::State::Forces, false, moving).getForces();
    std::vector<OpenMM::Vec3> velocities = openmm_vectors(fluid.velocities);
    for (std::size_t i = 0; i < velocities.size(); ++i) {
        velocities[i] -= forces[i] * (time_step / (2.0 * fluid.masses[i]));
    }
    return velocities;
}

}  // namespace ljmd
