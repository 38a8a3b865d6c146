#pragma once

#include <optional>
#include <string>

#include "ljmd/detail/reference/freezing.hpp"
#include "ljmd/detail/reference/phase_equilibrium.hpp"

namespace ljmd {

/// The phase of the Lennard-Jones fluid in a state, and whether it is the stable one.
enum class FluidPhase {
    gas,                 ///< below the critical temperature, less dense than the saturated vapour
    liquid,              ///< below the critical temperature, denser than the saturated liquid
    supercritical,       ///< at and above the critical temperature
    metastable_gas,      ///< denser than the saturated vapour, as far as the spinodal
    metastable_liquid,   ///< less dense than the saturated liquid, as far as the spinodal
    supercooled_liquid,  ///< between the freezing density of the fluid and the melting density of the crystal
    two_phases,          ///< between the spinodals: vapour and liquid
    solid                ///< above the melting density: the crystal
};

/// "gas", "liquid", "supercritical fluid", "metastable gas", "metastable liquid", "supercooled liquid", "two phases",
/// "solid"
[[nodiscard]] const char* name_of(FluidPhase phase);

/// A phase, with the lines of the phase diagram that it was found from.
struct PhaseOfState {
    FluidPhase phase;
    std::optional<Coexistence> saturation;      ///< at its temperature; empty at and above the critical one
    std::optional<Spinodals> spinodals;         ///< as saturation
    std::optional<FreezingDensities> freezing;  ///< of the full Lennard-Jones potential; empty where they are unknown

    /// The lines around the state in words: "saturated vapour 0.0057, saturated liquid 0.8051, freezing 0.855".
    [[nodiscard]] std::string lines() const;
};

/// The phase by an equation of state, and by the freezing and melting densities where they are known
/// (freezing_densities()).
/// @pre temperature > 0, density > 0
/// @throws PhysicsError  far below the triple point, as coexistence()
[[nodiscard]] PhaseOfState phase_of_state(const EquationOfState& equation, double temperature, double density);

}  // namespace ljmd
