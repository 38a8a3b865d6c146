#include "observables/squared_forces.hpp"

#include "execution/loops.hpp"

namespace ljmd {

double squared_forces_over_mass(const State& state) {
    const auto f = state.forces();
    return sum_over(state.execution(), state.count(),
                    [&](Index i) { return f.col(i).squaredNorm() / state.masses()[static_cast<std::size_t>(i)]; });
}

}  // namespace ljmd
