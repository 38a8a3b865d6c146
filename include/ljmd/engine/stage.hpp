#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ljmd/core/types.hpp"
#include "ljmd/integrators/barostat.hpp"
#include "ljmd/integrators/integrator.hpp"
#include "ljmd/integrators/thermostat.hpp"

namespace ljmd {

/// Steps of one integrator, with at most one thermostat and one barostat: one [[stage]] of a deck.
struct Stage {
    std::string name;
    ChosenIntegrator integrator;
    double time_step;  ///< [tau]
    Index steps;
    double temperature;  ///< target of the thermostat [epsilon/k_B]
    bool sample;         ///< whether observables are measured
    bool reverse;        ///< whether the motion is reversed before the first step
    std::optional<ChosenThermostat> thermostat = {};
    std::optional<ChosenBarostat> barostat = {};  ///< for a fluid only
    std::uint64_t seed = 0;                       ///< of the random numbers of thermostat and barostat
};

/// Whether a fluid conserves its total energy minus the heat from the thermostat in this stage, but for errors of the
/// integrator. It does without a thermostat, and with a canonical one if there is no barostat.
[[nodiscard]] bool conserves_energy(const Stage& stage);

}  // namespace ljmd
