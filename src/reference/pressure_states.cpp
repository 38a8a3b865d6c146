#include "ljmd/reference/pressure_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/roots.hpp"

namespace ljmd {

namespace {

double pressure_of(const EquationOfState& equation, double temperature, double density) {
    return properties(equation, temperature, density).pressure;
}

/// A density above `from` at which the pressure is higher than this. @throws PhysicsError  there is none
double denser_than(const EquationOfState& equation, double temperature, double pressure, double from) {
    constexpr double growth = 1.02;
    constexpr double densest = 3.0;           // far beyond what any formula was fitted to
    constexpr double no_more_critical = 0.5;  // below, near the critical point, rounding may make a slope negative
    for (double density = growth * from; density < densest; density *= growth) {
        const FluidProperties state = properties(equation, temperature, density);
        if (density > no_more_critical && state.pressure_density_slope <= 0.0) {
            break;
        }
        if (state.pressure >= pressure) {
            return density;
        }
    }
    throw PhysicsError(fmt::format("{} reaches no pressure of {} at temperature {}: too far from where it holds",
                                   equation.name, pressure, temperature));
}

/// The state with this pressure between two densities.
FluidProperties state_between(const EquationOfState& equation, double temperature, double pressure, double thin,
                              double dense) {
    const auto excess = [&](double density) { return pressure_of(equation, temperature, density) - pressure; };
    return properties(equation, temperature, find_root(excess, thin, dense));
}

/// The vapour pressure; none where the equation has no coexistence, because it is too cold.
std::optional<double> vapour_pressure(const EquationOfState& equation, double temperature) {
    try {
        const auto both = coexistence(equation, temperature);
        return both ? std::optional(both->pressure) : std::nullopt;
    } catch (const PhysicsError&) {
        return std::nullopt;
    }
}

}  // namespace

std::vector<PhaseAtPressure> states_at_pressure(const EquationOfState& equation, double temperature, double pressure) {
    const double thinnest = std::numeric_limits<double>::min();
    const auto ends = spinodals(equation, temperature);
    const double thin_end = ends ? ends->liquid : thinnest;
    std::vector<PhaseAtPressure> found;
    if (ends && pressure <= pressure_of(equation, temperature, ends->vapour)) {
        found.push_back({"vapour", state_between(equation, temperature, pressure, thinnest, ends->vapour), 0.0});
    }
    if (!ends || pressure >= pressure_of(equation, temperature, ends->liquid)) {
        const double first = std::max(thin_end, pressure / temperature * 1e-3);
        const double dense_end = denser_than(equation, temperature, pressure, first);
        found.push_back(
            {ends ? "liquid" : "fluid", state_between(equation, temperature, pressure, thin_end, dense_end), 0.0});
    }
    if (found.size() == 2) {
        if (chemical_potential(found[1].state) < chemical_potential(found[0].state)) {
            std::swap(found[0], found[1]);
        }
        found[1].gibbs_energy_difference = chemical_potential(found[1].state) - chemical_potential(found[0].state);
    }
    return found;
}

Coexistence coexistence_at_pressure(const EquationOfState& equation, double pressure) {
    constexpr double nearly = 1.0 - 1e-7;  // nearer to the critical point, liquid and vapour cannot be told apart
    constexpr double colder = 0.9;
    const CriticalPoint critical = critical_point(equation);
    const double highest = nearly * critical.temperature;
    const auto at_highest = vapour_pressure(equation, highest);
    if (pressure >= at_highest.value_or(critical.pressure)) {
        throw InputError(
            fmt::format("pressure {} is not below the critical pressure of {}, {:.6g}; above it there is one phase: "
                        "give its temperature, too",
                        pressure, equation.name, critical.pressure));
    }
    double lowest = std::min(equation.valid.lowest_temperature, colder * highest);
    std::optional<double> there = vapour_pressure(equation, lowest);
    std::optional<double> last = there;
    for (; there && *there > pressure; there = vapour_pressure(equation, lowest)) {
        last = there;
        lowest *= colder;
    }
    if (!there) {
        throw PhysicsError(
            fmt::format("{} has no vapour pressure as low as {}: the lowest is {:.3g}, at temperature {:.3g}",
                        equation.name, pressure, last.value_or(0.0), lowest / colder));
    }
    // The logarithm of the vapour pressure is nearly a linear function of 1/T.
    const double inverse =
        find_root([&](double x) { return std::log(coexistence(equation, 1.0 / x).value().pressure / pressure); },
                  1.0 / highest, 1.0 / lowest);
    return coexistence(equation, 1.0 / inverse).value();
}

}  // namespace ljmd
