#pragma once

#include <cstdint>
#include <string>

#include "ljmd/core/section.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// One [[stage]]: steps of one integrator, with one thermostat and one barostat at most.
struct Stage {
    std::string name;
    std::string integrator;
    double time_step;  ///< [tau]
    Index steps;
    double temperature;      ///< what a thermostat holds [epsilon/k_B]
    bool sample;             ///< observables are measured
    bool reverse;            ///< the motion is turned round before the first step
    Section section;         ///< for the keys of thermostat and barostat
    std::uint64_t seed = 0;  ///< of their random numbers
};

/// Whether the total energy of a fluid in this stage, less the heat of its thermostat, is conserved but for the errors
/// of the integrator: without thermostat, or with a canonical one and no barostat.
[[nodiscard]] bool conserves_energy(const Stage& stage);

}  // namespace ljmd
