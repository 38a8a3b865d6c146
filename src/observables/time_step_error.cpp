#include "observables/time_step_error.hpp"

#include "execution/loops.hpp"
#include "observables/squared_forces.hpp"

namespace ljmd {

void TimeStepError::add(const State& state, double time_step) {
    using Numbers = Eigen::Matrix<double, 8, 1>;
    const auto v = state.velocities();
    const auto f = state.forces();
    const auto sums = sum_over<Numbers>(state.execution(), state.count(), [&](Index i) {
        const double mass = state.masses()[static_cast<std::size_t>(i)];
        Numbers of_atom;
        of_atom << mass * v.col(i), f.col(i), mass, mass * v.col(i).squaredNorm();
        return of_atom;
    });
    const double mass = sums[6];
    const double forces = squared_forces_over_mass(state) - sums.segment<3>(3).squaredNorm() / mass;
    excess_ += 0.25 * time_step * time_step * forces;
    motion_ += sums[7] - sums.head<3>().squaredNorm() / mass;
}

std::optional<double> TimeStepError::value() const {
    if (!(motion_ > 0.0)) {
        return std::nullopt;
    }
    return excess_ / motion_;
}

}  // namespace ljmd
