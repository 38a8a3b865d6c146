#include "ljmd/reference/fluid_phase.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace ljmd {

namespace {

FluidPhase found_phase(const PhaseOfState& at, double density) {
    if (at.freezing && density >= at.freezing->melting) {
        return FluidPhase::solid;
    }
    if (at.freezing && density > at.freezing->freezing) {
        return FluidPhase::supercooled_liquid;
    }
    if (!at.saturation || !at.spinodals) {
        return FluidPhase::supercritical;
    }
    if (density <= at.saturation->vapour.density) {
        return FluidPhase::gas;
    }
    if (density >= at.saturation->liquid.density) {
        return FluidPhase::liquid;
    }
    return density < at.spinodals->vapour   ? FluidPhase::metastable_gas
           : density > at.spinodals->liquid ? FluidPhase::metastable_liquid
                                            : FluidPhase::two_phases;
}

}  // namespace

const char* name_of(FluidPhase phase) {
    switch (phase) {
        case FluidPhase::gas:
            return "gas";
        case FluidPhase::liquid:
            return "liquid";
        case FluidPhase::supercritical:
            return "supercritical fluid";
        case FluidPhase::metastable_gas:
            return "metastable gas";
        case FluidPhase::metastable_liquid:
            return "metastable liquid";
        case FluidPhase::supercooled_liquid:
            return "supercooled liquid";
        case FluidPhase::two_phases:
            return "two phases";
        case FluidPhase::solid:
            return "solid";
    }
    return "";
}

std::string PhaseOfState::lines() const {
    std::vector<std::string> lines;
    if (saturation) {
        lines.push_back(fmt::format("saturated vapour {:.4g}", saturation->vapour.density));
        lines.push_back(fmt::format("saturated liquid {:.4g}", saturation->liquid.density));
    }
    if (freezing) {
        lines.push_back(fmt::format("freezing {:.4g}", freezing->freezing));
        lines.push_back(fmt::format("melting {:.4g}", freezing->melting));
    }
    return fmt::format("{}", fmt::join(lines, ", "));
}

PhaseOfState phase_of_state(const EquationOfState& equation, double temperature, double density) {
    PhaseOfState found{FluidPhase::supercritical, coexistence(equation, temperature), spinodals(equation, temperature),
                       freezing_densities(temperature)};
    found.phase = found_phase(found, density);
    return found;
}

}  // namespace ljmd
