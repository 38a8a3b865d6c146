#include "engine/at_temperature.hpp"

namespace ljmd {

AtTemperature at_temperature(const EquationOfState& equation, double density, double temperature,
                             const MeansOfState& means, const EstimateFromMeans& estimate) {
    const double t = means[0];
    const double u = means[1];
    const double p = means[2];
    const FluidProperties here = properties(equation, t, density);
    const FluidProperties there = properties(equation, temperature, density);
    const double z = p / (density * t) + there.compressibility_factor - here.compressibility_factor;
    const double z_slope = (here.pressure_temperature_slope - here.pressure / t) / (density * t);  // dZ_m/dT
    const double u_slope = here.heat_capacity_cv - 1.5;                                            // dU_m/dT
    const Vec3 z_gradient(-p / (density * t * t) - z_slope, 0.0, 1.0 / (density * t));
    const double to_pressure = density * temperature;
    return {estimate(u + there.potential_energy - here.potential_energy, Vec3(-u_slope, 1.0, 0.0)),
            estimate(to_pressure * z, to_pressure * z_gradient), estimate(z, z_gradient)};
}

}  // namespace ljmd
