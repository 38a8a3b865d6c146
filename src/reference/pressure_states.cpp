#include "ljmd/reference/pressure_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/roots.hpp"
#include "ljmd/core/errors.hpp"
#include "reference/near_critical.hpp"

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

/// The vapour pressure; none where the equation has no coexistence, because it is too cold. It is a smooth function of
/// the temperature up to the critical one, and equals the pressure of the critical isochore but for terms of (T_c -
/// T)^2. These drown in rounding where the phases cannot be told apart either.
std::optional<double> vapour_pressure(const EquationOfState& equation, const CriticalPoint& critical,
                                      double temperature) {
    constexpr double nearly = 1.0 - 1e-10;
    if (temperature > nearly * critical.temperature) {
        return pressure_of(equation, temperature, critical.density);
    }
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
    // Near the critical temperature rounding may put the vapour's end below the liquid's.
    const double lowest_of_liquid = ends ? pressure_of(equation, temperature, ends->liquid) : 0.0;
    if (ends && pressure <= std::max(pressure_of(equation, temperature, ends->vapour), lowest_of_liquid)) {
        found.push_back({"vapour", phase_at(equation, temperature, pressure, thinnest, ends->vapour), 0.0});
    }
    if (!ends || pressure >= lowest_of_liquid) {
        const double first = std::max(thin_end, pressure / temperature * 1e-3);
        const double dense_end = denser_than(equation, temperature, pressure, first);
        found.push_back(
            {ends ? "liquid" : "fluid", phase_at(equation, temperature, pressure, thin_end, dense_end), 0.0});
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
    constexpr double colder = 0.9;
    const CriticalPoint critical = critical_point(equation);
    if (pressure >= critical.pressure) {
        throw InputError(
            fmt::format("pressure {} is not below the critical pressure of {}, {}; above it there is one phase: "
                        "give its temperature, too",
                        pressure, equation.name, critical_in_words(pressure, critical.pressure)));
    }
    double lowest = std::min(equation.valid.lowest_temperature, colder * critical.temperature);
    std::optional<double> there = vapour_pressure(equation, critical, lowest);
    std::optional<double> last = there;
    for (; there && *there > pressure; there = vapour_pressure(equation, critical, lowest)) {
        last = there;
        lowest *= colder;
    }
    if (!there) {
        throw PhysicsError(
            fmt::format("{} has no vapour pressure as low as {}: the lowest is {:.3g}, at temperature {:.3g}",
                        equation.name, pressure, last.value_or(0.0), lowest / colder));
    }
    // The logarithm of the vapour pressure is nearly a linear function of 1/T.
    const double hottest = 1.0 / critical.temperature;
    const auto excess = [&](double inverse) {
        return std::log(vapour_pressure(equation, critical, 1.0 / inverse).value() / pressure);
    };
    const auto found =
        excess(hottest) > 0.0 ? coexistence(equation, 1.0 / find_root(excess, hottest, 1.0 / lowest)) : std::nullopt;
    if (!found) {
        throw InputError(too_near_critical("pressure", pressure, equation.name, critical.pressure));
    }
    return *found;
}

}  // namespace ljmd
