#pragma once

namespace ljmd {

/// Ensemble of the samples.
enum class Ensemble {
    constant_energy,      ///< one stage of Newton's equations
    canonical,            ///< one stage with a canonical thermostat
    isothermal_isobaric,  ///< one stage with a barostat beside a canonical thermostat
    constant_pressure,    ///< the volume fluctuates, in one of several sampled stages
    none                  ///< anything else: only means are meaningful
};

/// Whether the volume fluctuates.
[[nodiscard]] constexpr bool volume_fluctuates(Ensemble ensemble) {
    return ensemble == Ensemble::isothermal_isobaric || ensemble == Ensemble::constant_pressure;
}

}  // namespace ljmd
