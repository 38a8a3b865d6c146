#include "compare/fluid.hpp"

namespace ljmd {

Fluid fluid_of(const State& state, const PairPotential& potential, bool tail) {
    const auto count = static_cast<std::size_t>(state.count());
    const Box& box = state.box();
    Fluid fluid{
        box.edges(), potential, tail, std::vector<double>(count), std::vector<Vec3>(count), std::vector<Vec3>(count)};
    for (Index i = 0; i < state.count(); ++i) {
        const auto id = static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)]);
        const Vec3 r = state.positions().col(i);
        fluid.positions[id] = r - box.crossings(r).cwiseProduct(box.edges());
        fluid.velocities[id] = state.velocities().col(i);
        fluid.masses[id] = state.masses()[static_cast<std::size_t>(i)];
    }
    return fluid;
}

State state_of(const Fluid& fluid, const Execution& execution) {
    State state(static_cast<Index>(fluid.positions.size()), Box(fluid.edges), execution);
    state.write_masses() = fluid.masses;
    auto r = state.write_positions();
    auto v = state.write_velocities();
    for (Index i = 0; i < state.count(); ++i) {
        r.col(i) = state.snapped(fluid.positions[static_cast<std::size_t>(i)]);
        v.col(i) = fluid.velocities[static_cast<std::size_t>(i)];
    }
    return state;
}

double kinetic_energy(const Fluid& fluid) {
    double twice = 0.0;
    for (std::size_t i = 0; i < fluid.velocities.size(); ++i) {
        twice += fluid.masses[i] * fluid.velocities[i].squaredNorm();
    }
    return 0.5 * twice;
}

}  // namespace ljmd
