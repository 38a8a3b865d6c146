#include "ljmd/model/velocities.hpp"

#include <cmath>
#include <numeric>

#include "ljmd/core/random.hpp"

namespace ljmd {

namespace {
double mass_of(const State& state, Index i) {
    return state.masses()[static_cast<std::size_t>(i)];
}
}  // namespace

Index degrees_of_freedom(Index atoms) {
    return atoms > 1 ? 3 * atoms - 3 : 0;
}

double kinetic_energy(const State& state) {
    const auto v = state.velocities();
    double twice = 0.0;
    for (Index i = 0; i < state.count(); ++i) {
        twice += mass_of(state, i) * v.col(i).squaredNorm();
    }
    return 0.5 * twice;
}

std::optional<double> temperature(const State& state) {
    const Index freedom = degrees_of_freedom(state.count());
    if (freedom == 0) {
        return std::nullopt;
    }
    return 2.0 * kinetic_energy(state) / static_cast<double>(freedom);
}

Vec3 total_momentum(const State& state) {
    const auto v = state.velocities();
    Vec3 momentum = Vec3::Zero();
    for (Index i = 0; i < state.count(); ++i) {
        momentum += mass_of(state, i) * v.col(i);
    }
    return momentum;
}

void draw_velocities(State& state, double target, std::uint64_t seed) {
    const Random random(seed, RandomStream::velocities);
    auto v = state.write_velocities();
    if (degrees_of_freedom(state.count()) == 0 || !(target > 0.0)) {
        v.setZero();
        return;
    }
    for (Index i = 0; i < state.count(); ++i) {
        const double width = std::sqrt(target / mass_of(state, i));
        v.col(i) = width * random.normal(0, state.ids()[static_cast<std::size_t>(i)]);
    }
    remove_momentum(state);
    rescale_velocities(state, target);
}

void remove_momentum(State& state) {
    if (state.count() == 0) {
        return;
    }
    const double mass = std::accumulate(state.masses().begin(), state.masses().end(), 0.0);
    const Vec3 drift = total_momentum(state) / mass;
    auto v = state.write_velocities();
    for (Index i = 0; i < state.count(); ++i) {
        v.col(i) -= drift;
    }
}

void rescale_velocities(State& state, double target) {
    const auto now = temperature(state);
    if (!now || !(*now > 0.0)) {
        return;
    }
    state.write_velocities() *= std::sqrt(target / *now);
}

}  // namespace ljmd
