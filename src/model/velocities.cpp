#include "model/velocities.hpp"

#include <cmath>

#include "core/random.hpp"
#include "execution/loops.hpp"

namespace ljmd {

namespace {
double mass_of(const State& state, Index i) {
    return state.masses()[static_cast<std::size_t>(i)];
}

double total_mass(const State& state) {
    return sum_over(state.execution(), state.count(), [&](Index i) { return mass_of(state, i); });
}
}  // namespace

Index degrees_of_freedom(Index atoms) {
    return atoms > 1 ? 3 * atoms - 3 : 0;
}

double kinetic_energy(const State& state) {
    const auto v = state.velocities();
    return 0.5 * sum_over(state.execution(), state.count(),
                          [&](Index i) { return mass_of(state, i) * v.col(i).squaredNorm(); });
}

std::optional<double> temperature(Index atoms, double kinetic_energy, const Vec3& momentum, double mass) {
    const Index freedom = degrees_of_freedom(atoms);
    if (freedom == 0) {
        return std::nullopt;
    }
    return (2.0 * kinetic_energy - momentum.squaredNorm() / mass) / static_cast<double>(freedom);
}

std::optional<double> temperature(const State& state) {
    return temperature(state.total(), kinetic_energy(state), total_momentum(state), total_mass(state));
}

Vec3 total_momentum(const State& state) {
    const auto v = state.velocities();
    return sum_over<Vec3>(state.execution(), state.count(), [&](Index i) { return mass_of(state, i) * v.col(i); });
}

void draw_velocities(State& state, double target, std::uint64_t seed) {
    const Random random(seed, RandomStream::velocities);
    auto v = state.write_velocities();
    if (degrees_of_freedom(state.total()) == 0 || !(target > 0.0)) {
        v.setZero();
        return;
    }
    for_each_index(state.execution(), state.count(), [&](Index i) {
        const double width = std::sqrt(target / mass_of(state, i));
        v.col(i) = width * random.normal(0, state.ids()[static_cast<std::size_t>(i)]);
    });
    remove_momentum(state);
    rescale_velocities(state, target);
}

Vec3 centre_velocity(const State& state) {
    return state.total() == 0 ? Vec3(Vec3::Zero()) : Vec3(total_momentum(state) / total_mass(state));
}

void shift_velocities(State& state, const Vec3& by) {
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) { v.col(i) += by; });
}

void remove_momentum(State& state) {
    state.finish_kick();
    shift_velocities(state, -centre_velocity(state));
}

void rescale_velocities(State& state, double target) {
    state.finish_kick();
    const auto now = temperature(state);
    if (!now || !(*now > 0.0)) {
        return;
    }
    scale_velocities(state, std::sqrt(target / *now));
}

void scale_velocities(State& state, double factor) {
    state.finish_kick();
    auto v = state.write_velocities();
    for_each_index(state.execution(), state.count(), [&](Index i) { v.col(i) *= factor; });
}

}  // namespace ljmd
