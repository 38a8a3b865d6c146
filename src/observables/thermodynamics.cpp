#include "ljmd/observables/thermodynamics.hpp"

#include <limits>

#include "ljmd/execution/loops.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

namespace {

/// sum m u u for u = (v, 1): sum m v v in the first three rows, sum m v and sum m in the last one.
Eigen::Matrix4d kinetic_sums(const State& state) {
    const auto v = state.velocities();
    return sum_over(state.execution(), state.count(), Eigen::Matrix4d(Eigen::Matrix4d::Zero()), [&](Index i) {
        // The three components of a velocity are followed by a zero.
        const Eigen::Vector4d u = Eigen::Map<const Eigen::Vector4d>(v.col(i).data()) + Eigen::Vector4d::UnitW();
        const double mass = state.masses()[static_cast<std::size_t>(i)];
        return Eigen::Matrix4d((mass * u) * u.transpose());
    });
}

}  // namespace

Thermodynamics thermodynamics(const State& state, const Evaluation& evaluation, const TailCorrection& tail) {
    const auto atoms = static_cast<double>(state.count());
    const double volume = state.box().volume();
    const double density = atoms / volume;

    const Eigen::Matrix4d sums = kinetic_sums(state);
    const Mat3 kinetic_tensor = sums.topLeftCorner<3, 3>();
    const Vec3 momentum = sums.topRightCorner<3, 1>();
    const double mass = sums(3, 3);
    const double kinetic_energy = 0.5 * kinetic_tensor.trace();

    Thermodynamics result;
    result.temperature = temperature(state.count(), kinetic_energy, momentum, mass);
    result.potential_energy = evaluation.potential_energy / atoms + tail.energy(density);
    result.kinetic_energy = kinetic_energy / atoms;
    result.total_energy = result.potential_energy + result.kinetic_energy;
    if (evaluation.external_energy) {
        result.external_energy = *evaluation.external_energy / atoms;
        result.total_energy += *result.external_energy;
    }
    if (result.temperature) {
        const Mat3 about_centre = kinetic_tensor - momentum * momentum.transpose() / mass;
        result.pressure_tensor = (atoms / (atoms - 1.0) * about_centre + evaluation.virial) / volume +
                                 tail.pressure(density) * Mat3::Identity();
        result.pressure = result.pressure_tensor->trace() / 3.0;
    }
    result.density = density;
    result.edges = state.box().edges();
    result.virial = evaluation.virial.trace();
    return result;
}

bool is_above_zero(double temperature) {
    return temperature > std::numeric_limits<double>::epsilon();
}

double virial_pressure(const State& state, const Evaluation& evaluation, const TailCorrection& tail) {
    const double volume = state.box().volume();
    return evaluation.virial.trace() / (3.0 * volume) + tail.pressure(static_cast<double>(state.count()) / volume);
}

Vec3 virial_pressures(const State& state, const Evaluation& evaluation, const TailCorrection& tail) {
    const double volume = state.box().volume();
    return (evaluation.virial.diagonal() / volume).array() + tail.pressure(static_cast<double>(state.count()) / volume);
}

Mat3 mechanical_stress(const State& state, const Evaluation& evaluation) {
    return (kinetic_sums(state).topLeftCorner<3, 3>() + evaluation.virial) / state.box().volume();
}

}  // namespace ljmd
