#include "ljmd/detail/engine/energy_start.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"
#include "model/velocities.hpp"

namespace ljmd {

EnergyStart scale_to_total_energy(State& state, const Thermodynamics& now, double total_energy) {
    const double potential = now.total_energy - now.kinetic_energy;
    const double wanted = total_energy - potential;
    if (!(wanted > 0.0)) {
        throw PhysicsError(fmt::format(
            "total_energy is {:.10g} epsilon per atom, but the atoms have a potential energy of {:.10g} where they "
            "are: "
            "no motion has a negative kinetic energy; equilibrate at a lower temperature first, or ask for more energy",
            total_energy, potential));
    }
    if (!(now.kinetic_energy > 0.0)) {
        throw PhysicsError("the atoms are at rest: there are no velocities to scale to total_energy");
    }
    const EnergyStart start{total_energy, potential, now.kinetic_energy, std::sqrt(wanted / now.kinetic_energy)};
    scale_velocities(state, start.velocity_factor);
    return start;
}

}  // namespace ljmd
