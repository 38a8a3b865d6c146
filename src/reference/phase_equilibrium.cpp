#include "ljmd/detail/reference/phase_equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/roots.hpp"
#include "ljmd/core/errors.hpp"
#include "reference/near_critical.hpp"

namespace ljmd {

namespace {

// Ranges that hold the critical points of Lennard-Jones fluids, which lie at 1.086 to 1.34 and 0.31 to 0.32, truncated
// fluids included.
constexpr double lowest_critical_temperature = 0.95;
constexpr double highest_critical_temperature = 1.5;
constexpr double thinnest_critical_density = 0.2;
constexpr double thickest_critical_density = 0.45;

constexpr double thinnest_vapour = std::numeric_limits<double>::min();
constexpr double densest_liquid = 1.1;
constexpr int scan_steps = 200;

/// Spinodals nearer than this [sigma^-3] have pressures and chemical potentials that differ in few digits.
constexpr double near_spinodals = 0.02;

/// The point of an isotherm with the smallest slope, among densities that can be critical. Formulas with many terms
/// have several inflections between the spinodals, and a root of d2p/drho2 may be any of them. So the whole range is
/// scanned.
FluidProperties min_steep(const EquationOfState& equation, double temperature) {
    constexpr double step = (thickest_critical_density - thinnest_critical_density) / scan_steps;
    FluidProperties least = properties(equation, temperature, thinnest_critical_density);
    for (int i = 1; i <= scan_steps; ++i) {
        const FluidProperties here = properties(equation, temperature, thinnest_critical_density + i * step);
        if (here.pressure_density_slope < least.pressure_density_slope) {
            least = here;
        }
    }
    const auto curvature = [&](double density) {
        return properties(equation, temperature, density).pressure_density_curvature;
    };
    const double before = least.density - step;
    const double after = least.density + step;
    if (curvature(before) < 0.0 && curvature(after) > 0.0) {
        least = properties(equation, temperature, find_root(curvature, before, after));
    }
    return least;
}

/// The first density, on the way from a stable to an unstable one, at which the slope dp/drho is zero. The range is
/// scanned, because formulas with many terms oscillate between the spinodals.
double spinodal(const EquationOfState& equation, double temperature, double stable, double unstable) {
    const auto slope = [&](double density) {
        return properties(equation, temperature, density).pressure_density_slope;
    };
    double before = stable;
    const bool begins_stable = slope(stable) > 0.0;
    for (int step = 1; begins_stable && step <= scan_steps; ++step) {
        const double density = std::lerp(stable, unstable, static_cast<double>(step) / scan_steps);
        if (slope(density) <= 0.0) {
            return find_root(slope, before, density);
        }
        before = density;
    }
    throw PhysicsError(fmt::format("{} has no stable liquid or vapour at temperature {}: it was fitted from {} to {}",
                                   equation.name, temperature, equation.valid.lowest_temperature,
                                   equation.valid.highest_temperature));
}

}  // namespace

FluidProperties phase_at(const EquationOfState& equation, double temperature, double pressure, double thin,
                         double dense) {
    const auto excess = [&](double density) { return properties(equation, temperature, density).pressure - pressure; };
    const double density = excess(thin) >= 0.0 ? thin : excess(dense) <= 0.0 ? dense : find_root(excess, thin, dense);
    return properties(equation, temperature, density);
}

double chemical_potential(const FluidProperties& phase) {
    return phase.temperature * std::log(phase.density) + phase.excess_chemical_potential;
}

CriticalPoint critical_point(const EquationOfState& equation) {
    const double temperature = find_root([&](double t) { return min_steep(equation, t).pressure_density_slope; },
                                         lowest_critical_temperature, highest_critical_temperature);
    const FluidProperties point = min_steep(equation, temperature);
    return {temperature, point.density, point.pressure};
}

double Coexistence::heat_of_vaporisation() const {
    return vapour.potential_energy - liquid.potential_energy + pressure * (1.0 / vapour.density - 1.0 / liquid.density);
}

std::optional<Spinodals> spinodals(const EquationOfState& equation, double temperature) {
    const FluidProperties unstable = min_steep(equation, temperature);
    if (unstable.pressure_density_slope >= 0.0) {
        return std::nullopt;
    }
    return Spinodals{spinodal(equation, temperature, thinnest_vapour, unstable.density),
                     spinodal(equation, temperature, densest_liquid, unstable.density)};
}

std::optional<Coexistence> coexistence(const EquationOfState& equation, double temperature) {
    const auto ends = spinodals(equation, temperature);
    if (!ends) {
        return std::nullopt;
    }
    if (ends->liquid - ends->vapour < near_spinodals) {
        const auto densities = saturated_near_critical(equation, temperature, *ends);
        if (!densities) {
            return std::nullopt;
        }
        const FluidProperties liquid = properties(equation, temperature, densities->liquid);
        const FluidProperties vapour = properties(equation, temperature, densities->vapour);
        return Coexistence{0.5 * (liquid.pressure + vapour.pressure), liquid, vapour};
    }
    const double end_of_vapour = ends->vapour;
    const double end_of_liquid = ends->liquid;
    const auto both = [&](double pressure) {
        return Coexistence{pressure, phase_at(equation, temperature, pressure, end_of_liquid, densest_liquid),
                           phase_at(equation, temperature, pressure, thinnest_vapour, end_of_vapour)};
    };
    // The search is in the logarithm, because at low temperatures the pressure is a small fraction of that at the
    // spinodal.
    const double highest = properties(equation, temperature, end_of_vapour).pressure;
    const double stretched = properties(equation, temperature, end_of_liquid).pressure;
    constexpr double lowest_part = 1e-12;
    const double lowest = std::max(stretched, lowest_part * highest);
    const double logarithm = find_root(
        [&](double log_pressure) {
            const Coexistence trial = both(std::exp(log_pressure));
            return chemical_potential(trial.liquid) - chemical_potential(trial.vapour);
        },
        std::log(lowest), std::log(highest));
    return both(std::exp(logarithm));
}

}  // namespace ljmd
