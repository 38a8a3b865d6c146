#include "ljmd/observables/thermodynamics.hpp"

#include "ljmd/core/threads.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

Thermodynamics thermodynamics(const State& state, const Evaluation& evaluation, const TailCorrection& tail) {
    const auto atoms = static_cast<double>(state.count());
    const double volume = state.box().volume();
    const double density = atoms / volume;

    // sum m u u of u = (v, 1): sum m v v in the first three rows, sum m v and sum m in the last one.
    const auto v = state.velocities();
    const Eigen::Matrix4d sums = sum_over(state.count(), Eigen::Matrix4d(Eigen::Matrix4d::Zero()), [&](Index i) {
        // Behind the three components of a velocity lies a zero.
        const Eigen::Vector4d u = Eigen::Map<const Eigen::Vector4d>(v.col(i).data()) + Eigen::Vector4d::UnitW();
        const double mass = state.masses()[static_cast<std::size_t>(i)];
        return Eigen::Matrix4d((mass * u) * u.transpose());
    });
    const Mat3 kinetic_tensor = sums.topLeftCorner<3, 3>();
    const double kinetic_energy = 0.5 * kinetic_tensor.trace();

    Thermodynamics result;
    result.temperature = temperature(state.count(), kinetic_energy, sums.topRightCorner<3, 1>(), sums(3, 3));
    result.potential_energy = evaluation.potential_energy / atoms + tail.energy(density);
    result.kinetic_energy = kinetic_energy / atoms;
    result.total_energy = result.potential_energy + result.kinetic_energy;
    result.pressure_tensor = (kinetic_tensor + evaluation.virial) / volume + tail.pressure(density) * Mat3::Identity();
    result.pressure = result.pressure_tensor.trace() / 3.0;
    result.density = density;
    result.virial = evaluation.virial.trace();
    return result;
}

}  // namespace ljmd
