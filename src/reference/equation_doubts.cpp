#include "reference/equation_doubts.hpp"

#include <fmt/format.h>

#include <optional>

#include "ljmd/detail/reference/freezing.hpp"
#include "ljmd/detail/reference/phase_equilibrium.hpp"

namespace ljmd {

namespace {

/// Message for a fluid above its freezing density; nothing for other states, and for fluids of unknown freezing
/// density.
std::optional<std::string> frozen(const EquationOfState& equation, double temperature, double density) {
    const auto densities = equation.full_potential ? freezing_densities(temperature) : std::nullopt;
    if (!densities || density <= densities->freezing) {
        return std::nullopt;
    }
    if (density < densities->melting) {
        return fmt::format(
            "at temperature {} fluid of density {:.4f} and crystal of density {:.4f} coexist (Mastny and de Pablo "
            "2007); "
            "in between {} describes a metastable fluid",
            temperature, densities->freezing, densities->melting, equation.name);
    }
    return fmt::format(
        "at temperature {} the fluid freezes at density {:.4f} and the crystal melts at {:.4f} (Mastny and de Pablo "
        "2007); "
        "above that the crystal is stable and {} describes a metastable fluid",
        temperature, densities->freezing, densities->melting, equation.name);
}

}  // namespace

std::vector<std::string> doubts(const EquationOfState& equation, double temperature, double density) {
    std::vector<std::string> found;
    const std::string outside = outside_of_range(equation, properties(equation, temperature, density));
    if (!outside.empty()) {
        found.push_back(outside);
    }
    if (const auto freezing = frozen(equation, temperature, density)) {
        found.push_back(*freezing);
    }
    if (!found.empty()) {
        return found;  // a formula may have no coexistence where it does not hold
    }
    const auto phases = coexistence(equation, temperature);
    if (phases && density > phases->vapour.density && density < phases->liquid.density) {
        found.push_back(fmt::format(
            "at temperature {} vapour of density {:.6g} and liquid of density {:.6g} coexist; in between {} describes "
            "no stable phase",
            temperature, phases->vapour.density, phases->liquid.density, equation.name));
    }
    return found;
}

}  // namespace ljmd
