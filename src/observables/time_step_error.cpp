#include "ljmd/observables/time_step_error.hpp"

#include "ljmd/execution/loops.hpp"

namespace ljmd {

void TimeStepError::add(const State& state, double time_step) {
    const auto f = state.forces();
    const auto v = state.velocities();
    const Eigen::Vector2d sums = sum_over(state.execution(), state.count(), Eigen::Vector2d(0.0, 0.0), [&](Index i) {
        const double mass = state.masses()[static_cast<std::size_t>(i)];
        return Eigen::Vector2d(f.col(i).squaredNorm() / mass, mass * v.col(i).squaredNorm());
    });
    excess_ += 0.25 * time_step * time_step * sums[0];
    motion_ += sums[1];
}

std::optional<double> TimeStepError::value() const {
    if (!(motion_ > 0.0)) {
        return std::nullopt;
    }
    return excess_ / motion_;
}

}  // namespace ljmd
