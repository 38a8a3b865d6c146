#include "ljmd/observables/time_step_error.hpp"

#include "ljmd/execution/loops.hpp"
#include "ljmd/observables/squared_forces.hpp"

namespace ljmd {

void TimeStepError::add(const State& state, double time_step) {
    const auto v = state.velocities();
    excess_ += 0.25 * time_step * time_step * squared_forces_over_mass(state);
    motion_ += sum_over(state.execution(), state.count(),
                        [&](Index i) { return state.masses()[static_cast<std::size_t>(i)] * v.col(i).squaredNorm(); });
}

std::optional<double> TimeStepError::value() const {
    if (!(motion_ > 0.0)) {
        return std::nullopt;
    }
    return excess_ / motion_;
}

}  // namespace ljmd
