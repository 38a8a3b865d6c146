#include "page/phase_diagram.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/reference/fluid_phase.hpp"

namespace ljmd {

namespace {

constexpr int points = 60;

EquationOfState equation() {
    return equation_of_state("thol2016");
}

}  // namespace

Data phase_diagram() {
    const EquationOfState thol = equation();
    const CriticalPoint critical = critical_point(thol);
    Data saturation = Data::list();
    for (int k = 0; k < points; ++k) {
        // Denser towards the critical point, where the lines are flat.
        const double t = 1.0 - static_cast<double>(k) / points;
        const double temperature = critical.temperature - (critical.temperature - triple_point_temperature) * t * t * t;
        const auto phases = coexistence(thol, temperature);
        const auto limits = spinodals(thol, temperature);
        if (phases && limits) {
            saturation.push_back(Data::list({temperature, phases->vapour.density, limits->vapour, limits->liquid,
                                             phases->liquid.density, phases->pressure}));
        }
    }
    saturation.push_back(Data::list({critical.temperature, critical.density, critical.density, critical.density,
                                     critical.density, critical.pressure}));
    Data freezing = Data::list();
    for (int k = 0; k <= points; ++k) {
        const double temperature =
            triple_point_temperature + (highest_freezing_temperature - triple_point_temperature) * k / points;
        if (const auto densities = freezing_densities(temperature)) {
            freezing.push_back(Data::list({temperature, densities->freezing, densities->melting}));
        }
    }
    return {{"saturation", std::move(saturation)},
            {"freezing", std::move(freezing)},
            {"critical", {{"temperature", critical.temperature}, {"density", critical.density}}},
            {"triple_temperature", triple_point_temperature}};
}

Data equation_at(double temperature, double density) {
    const EquationOfState thol = equation();
    const FluidProperties fluid = properties(thol, temperature, density);
    return {{"equation", thol.name},
            {"pressure", fluid.pressure},
            {"potential_energy", fluid.potential_energy},
            {"outside", outside_of_range(thol, fluid)}};
}

Data state_of_fluid(double temperature, double density) {
    Data data = equation_at(temperature, density);
    try {
        const PhaseOfState phase = phase_of_state(equation(), temperature, density);
        const bool is_cold = temperature < triple_point_temperature && phase.phase != FluidPhase::gas;
        data["fluid"] = !is_cold && phase.phase != FluidPhase::solid && phase.phase != FluidPhase::two_phases;
        if (is_cold) {
            data["phase"] = "crystal, with vapour where there is room";
            data["lines"] = "a liquid is supercooled below the triple point";
        } else if (phase.phase == FluidPhase::solid) {
            data["phase"] = "crystal";
            data["lines"] = fmt::format("a liquid would be supercooled; {}", phase.lines());
        } else if (phase.phase == FluidPhase::supercooled_liquid) {
            data["phase"] = "crystal beside liquid";
            data["lines"] =
                fmt::format("a liquid alone is supercooled, a crystal alone superheated; {}", phase.lines());
        } else {
            data["phase"] = name_of(phase.phase);
            data["lines"] = phase.lines();
        }
        data["stable"] = phase.phase != FluidPhase::metastable_gas && phase.phase != FluidPhase::metastable_liquid &&
                         phase.phase != FluidPhase::two_phases;
        if (phase.phase == FluidPhase::two_phases && phase.saturation) {
            data["saturation_pressure"] = phase.saturation->pressure;
        }
    } catch (const PhysicsError& error) {
        data["phase"] = nullptr;  // far below the triple point
        data["lines"] = error.what();
        data["stable"] = false;
        data["fluid"] = false;
    }
    return data;
}

}  // namespace ljmd
