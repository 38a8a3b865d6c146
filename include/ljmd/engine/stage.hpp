#pragma once

#include <cstdint>
#include <string>

#include "ljmd/core/section.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// One [[stage]]: steps of one integrator, with at most one thermostat and one barostat.
struct Stage {
    std::string name;
    std::string integrator;
    double time_step;  ///< [tau]
    Index steps;
    double temperature;      ///< target of the thermostat [epsilon/k_B]
    bool sample;             ///< whether observables are measured
    bool reverse;            ///< whether the motion is reversed before the first step
    Section section;         ///< options of integrator, thermostat and barostat
    std::uint64_t seed = 0;  ///< of the random numbers of thermostat and barostat
};

/// Whether a fluid conserves its total energy minus the heat from the thermostat in this stage, but for errors of the
/// integrator. It does without a thermostat, and with a canonical one if there is no barostat.
[[nodiscard]] bool conserves_energy(const Stage& stage);

}  // namespace ljmd
