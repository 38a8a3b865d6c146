#include "integrators/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "execution/loops.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr double longest_move = 0.1;  // [sigma]

/// Constants of the FIRE paper, with time steps for reduced units.
struct FireConstants {
    double first_step = 0.002;
    double longest_step = 0.02;
    double step_growth = 1.1;
    double step_shrinkage = 0.5;
    double first_mixing = 0.1;
    double mixing_decay = 0.99;
    Index patience = 5;  // downhill iterations before the step may grow
};

/// Largest force; infinite if any force is NaN.
double largest_force(const State& state) {
    const auto f = state.forces();
    double largest = 0.0;
    for (Index i = 0; i < state.count(); ++i) {
        const double force = f.col(i).norm();
        largest = std::isnan(force) ? std::numeric_limits<double>::infinity() : std::max(largest, force);
    }
    state.execution().ranks().largest({&largest, 1});
    return largest;
}

/// v = (1 - mixing) v + mixing |v| f/|f|: turn the velocity towards the force. @return whether f.v > 0, that is,
/// downhill
bool steer(State& state, double mixing) {
    auto v = state.write_velocities();
    const auto f = static_cast<const State&>(state).forces();
    // f.v, f^2 and v^2 of all atoms together
    const auto sums = sum_over<Vec3>(state.execution(), state.count(), [&](Index i) {
        return Vec3(f.col(i).dot(v.col(i)), f.col(i).squaredNorm(), v.col(i).squaredNorm());
    });
    if (!(sums[0] > 0.0)) {
        v.setZero();
        return false;
    }
    if (sums[1] > 0.0) {
        const double scale = mixing * std::sqrt(sums[2] / sums[1]);
        v = (1.0 - mixing) * v + scale * f;
    }
    return true;
}

void move(State& state, double step) {
    auto r = state.write_positions();
    const auto v = state.velocities();
    for (Index i = 0; i < state.count(); ++i) {
        Vec3 d = step * v.col(i);
        const double length = d.norm();
        if (length > longest_move) {
            d *= longest_move / length;
        }
        r.col(i) = state.snapped(r.col(i) + d);
    }
}

}  // namespace

Relaxation relax(State& state, ForceField& force_field, double force_tolerance, Index max_iterations) {
    const FireConstants fire;
    double step = fire.first_step;
    double mixing = fire.first_mixing;
    Index downhill = 0;
    state.write_velocities().setZero();
    Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    Index iteration = 0;
    while (!(largest_force(state) <= force_tolerance)) {
        if (iteration == max_iterations) {
            throw PhysicsError(
                fmt::format("{} iterations did not relax the overlaps of the start: the largest force is "
                            "{:.3g}. Is the density too high?",
                            iteration, largest_force(state)));
        }
        ++iteration;
        if (steer(state, mixing)) {
            if (++downhill > fire.patience) {
                step = std::min(step * fire.step_growth, fire.longest_step);
                mixing *= fire.mixing_decay;
            }
        } else {
            downhill = 0;
            step *= fire.step_shrinkage;
            mixing = fire.first_mixing;
        }
        state.write_velocities() += step * static_cast<const State&>(state).forces();
        move(state, step);
        evaluation = force_field.evaluate(state, Request::forces_and_energy);
    }
    state.write_velocities().setZero();
    state.wrap();
    for (Index i = 0; i < state.count(); ++i) {
        state.set_image(i, Eigen::Vector3i::Zero());
    }
    return {iteration, largest_force(state), evaluation.potential_energy};
}

}  // namespace ljmd
