#include "ljmd/detail/observables/thermodynamics.hpp"

#include <limits>

#include "execution/loops.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

struct KineticSums {
    Mat3 tensor;    ///< sum m v v
    Vec3 momentum;  ///< sum m v
    double mass;    ///< sum m
};

KineticSums kinetic_sums(const State& state) {
    using Numbers = Eigen::Matrix<double, 10, 1>;
    const auto v = state.velocities();
    const auto s = sum_over<Numbers>(state.execution(), state.count(), [&](Index i) {
        const double mass = state.masses()[static_cast<std::size_t>(i)];
        const Vec3 u = v.col(i);
        const Vec3 p = mass * u;
        Numbers of_atom;
        of_atom << p[0] * u[0], p[1] * u[1], p[2] * u[2], p[0] * u[1], p[0] * u[2], p[1] * u[2], p, mass;
        return of_atom;
    });
    KineticSums sums;
    sums.tensor << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
    sums.momentum = s.segment<3>(6);
    sums.mass = s[9];
    return sums;
}

/// sum m (v - V) (v - V) with the velocity V of the centre of mass.
Mat3 about_centre(const KineticSums& sums) {
    return sums.tensor - sums.momentum * sums.momentum.transpose() / sums.mass;
}

}  // namespace

Thermodynamics thermodynamics(const State& state, const Evaluation& evaluation, const TailCorrection& tail) {
    const auto atoms = static_cast<double>(state.total());
    const double volume = state.box().volume();
    const double density = atoms / volume;

    const KineticSums sums = kinetic_sums(state);
    const double kinetic_energy = 0.5 * sums.tensor.trace();

    Thermodynamics result;
    result.temperature = temperature(state.total(), kinetic_energy, sums.momentum, sums.mass);
    result.potential_energy = evaluation.potential_energy / atoms + tail.energy(density);
    result.kinetic_energy = kinetic_energy / atoms;
    result.total_energy = result.potential_energy + result.kinetic_energy;
    if (evaluation.external_energy) {
        result.external_energy = *evaluation.external_energy / atoms;
        result.total_energy += *result.external_energy;
    }
    if (result.temperature) {
        result.pressure_tensor = (atoms / (atoms - 1.0) * about_centre(sums) + evaluation.virial) / volume +
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
    return evaluation.virial.trace() / (3.0 * volume) + tail.pressure(static_cast<double>(state.total()) / volume);
}

Vec3 virial_pressures(const State& state, const Evaluation& evaluation, const TailCorrection& tail) {
    const double volume = state.box().volume();
    return (evaluation.virial.diagonal() / volume).array() + tail.pressure(static_cast<double>(state.total()) / volume);
}

Mat3 mechanical_stress(const State& state, const Evaluation& evaluation) {
    return (about_centre(kinetic_sums(state)) + evaluation.virial) / state.box().volume();
}

}  // namespace ljmd
