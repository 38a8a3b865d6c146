#include "reference/canonical_size.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr double relative_step = 1e-3;  // of central differences: their error is 1e-6, rounding 1e-9

}  // namespace

double structure_factor_at_zero(const EquationOfState& equation, double temperature, double density, double tail) {
    const double slope = properties(equation, temperature, density).pressure_density_slope - 2.0 * tail * density;
    if (!(slope > 0.0)) {
        throw PhysicsError(
            fmt::format("no phase is stable at temperature {} and density {}: the pressure does not "
                        "rise with the density",
                        temperature, density));
    }
    return temperature / slope;
}

SizeShift canonical_size_shift(const EquationOfState& equation, double temperature, double density, Index atoms,
                               double tail) {
    const double t = temperature;
    const double rho = density;
    const double dt = relative_step * t;
    const double drho = relative_step * rho;
    const auto s = [&](double at_t, double at_rho) {
        return std::log(structure_factor_at_zero(equation, at_t, at_rho, tail));
    };
    const double here = s(t, rho);
    const double s_t = (s(t + dt, rho) - s(t - dt, rho)) / (2.0 * dt);
    const double s_tt = (s(t + dt, rho) - 2.0 * here + s(t - dt, rho)) / (dt * dt);
    const double s_rho = (s(t, rho + drho) - s(t, rho - drho)) / (2.0 * drho);
    const double s_rhorho = (s(t, rho + drho) - 2.0 * here + s(t, rho - drho)) / (drho * drho);
    const double s_trho =
        (s(t + dt, rho + drho) - s(t + dt, rho - drho) - s(t - dt, rho + drho) + s(t - dt, rho - drho)) /
        (4.0 * dt * drho);
    const double slope = properties(equation, t, rho).pressure_density_slope;
    const double half = 0.5 / static_cast<double>(atoms);
    return {.potential_energy = -half * t * t * s_t,
            .pressure = half * rho * rho * t * s_rho,
            .excess_chemical_potential = half * (slope - t + rho * t * s_rho),
            .heat_capacity_cv = -half * (2.0 * t * s_t + t * t * s_tt),
            .thermal_pressure = half * rho * rho * (s_rho + t * s_trho),
            .bulk_modulus = half * t * (2.0 * rho * rho * s_rho + rho * rho * rho * s_rhorho)};
}

}  // namespace ljmd
