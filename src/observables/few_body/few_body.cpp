#include "ljmd/detail/observables/few_body/few_body.hpp"

#include <Eigen/Geometry>

#include "model/velocities.hpp"

namespace ljmd {

Vec3 angular_momentum(const State& state) {
    const auto r = state.positions();
    const auto v = state.velocities();
    Vec3 sum = Vec3::Zero();
    for (Index i = 0; i < state.count(); ++i) {
        sum += state.masses()[static_cast<std::size_t>(i)] * Vec3(r.col(i)).cross(Vec3(v.col(i)));
    }
    return sum;
}

Vec3 centre_of_mass(const State& state) {
    const auto r = state.positions();
    Vec3 sum = Vec3::Zero();
    double mass = 0.0;
    for (Index i = 0; i < state.count(); ++i) {
        const double m = state.masses()[static_cast<std::size_t>(i)];
        sum += m * r.col(i);
        mass += m;
    }
    return sum / mass;
}

FewBodyTotals few_body_totals(const State& state, double potential_energy) {
    const double kinetic = kinetic_energy(state);
    return {potential_energy, kinetic, potential_energy + kinetic, total_momentum(state), angular_momentum(state)};
}

}  // namespace ljmd
