#include "ljmd/observables/thermodynamics.hpp"

#include "ljmd/core/threads.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

Thermodynamics thermodynamics(const State& state, const Evaluation& evaluation, const TailCorrection& tail) {
    const auto atoms = static_cast<double>(state.count());
    const double volume = state.box().volume();
    const double density = atoms / volume;

    const auto v = state.velocities();
    // sum m v v
    const Mat3 kinetic_tensor = sum_over(state.count(), Mat3(Mat3::Zero()), [&](Index i) -> Mat3 {
        return state.masses()[static_cast<std::size_t>(i)] * v.col(i) * v.col(i).transpose();
    });

    Thermodynamics result;
    result.temperature = temperature(state);
    result.potential_energy = evaluation.potential_energy / atoms + tail.energy(density);
    result.kinetic_energy = 0.5 * kinetic_tensor.trace() / atoms;
    result.total_energy = result.potential_energy + result.kinetic_energy;
    result.pressure_tensor = (kinetic_tensor + evaluation.virial) / volume + tail.pressure(density) * Mat3::Identity();
    result.pressure = result.pressure_tensor.trace() / 3.0;
    result.density = density;
    result.virial = evaluation.virial.trace();
    return result;
}

}  // namespace ljmd
