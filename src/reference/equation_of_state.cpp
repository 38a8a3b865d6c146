#include "ljmd/detail/reference/equation_of_state.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ljmd/core/errors.hpp"
#include "ljmd/detail/options/registry.hpp"

namespace ljmd {

namespace {

constexpr double ideal_cv = 1.5;             ///< c_v/k_B of a monatomic ideal gas
constexpr double ideal_cp = ideal_cv + 1.0;  ///< c_p/k_B

/// a with its derivatives; derivative(i, j) is the i-th in T and the j-th in rho.
Taylor residual(const EquationOfState& equation, double temperature, double density) {
    return equation.residual_helmholtz(Taylor::x(temperature), Taylor::y(density));
}

}  // namespace

EquationOfState equation_of_state(const std::string& name) {
    return find_plugin(all_equations_of_state(), name, "equation of state");
}

FluidProperties properties(const EquationOfState& equation, double temperature, double density) {
    const Taylor a = residual(equation, temperature, density);
    const double a_t = temperature * a.derivative(1, 0);
    const double a_tt = temperature * temperature * a.derivative(2, 0);
    const double a_r = density * a.derivative(0, 1);
    const double a_rr = density * density * a.derivative(0, 2);
    const double a_tr = temperature * density * a.derivative(1, 1);
    FluidProperties state{};
    state.temperature = temperature;
    state.density = density;
    state.compressibility_factor = 1.0 + a_r;
    state.pressure = density * temperature * state.compressibility_factor;
    state.potential_energy = -temperature * a_t;
    state.residual_heat_capacity_cv = -2.0 * a_t - a_tt;
    state.heat_capacity_cv = ideal_cv + state.residual_heat_capacity_cv;
    state.residual_helmholtz_energy = temperature * a.value();
    state.excess_chemical_potential = temperature * (a.value() + a_r);
    state.pressure_density_slope = temperature * (1.0 + 2.0 * a_r + a_rr);
    state.pressure_temperature_slope = density * (1.0 + a_r + a_tr);
    state.pressure_density_curvature = temperature * (2.0 * a.derivative(0, 1) + 4.0 * density * a.derivative(0, 2) +
                                                      density * density * a.derivative(0, 3));
    state.non_ideal_expansion = temperature * a.derivative(1, 1) - a.derivative(0, 1) - density * a.derivative(0, 2);
    if (state.pressure_density_slope > 0.0 && density > 0.0) {
        const double b = a_r + a_tr;
        state.residual_heat_capacity_cp =
            state.residual_heat_capacity_cv + (2.0 * a_tr - a_rr + b * b) / (1.0 + 2.0 * a_r + a_rr);
    }
    if (!std::isfinite(state.pressure) || !std::isfinite(state.potential_energy)) {
        throw PhysicsError(
            fmt::format("{} gives no pressure at temperature {} and density {}: too far from where it holds",
                        equation.name, temperature, density));
    }
    return state;
}

std::optional<double> FluidProperties::heat_capacity_cp() const {
    return residual_heat_capacity_cp ? std::optional(ideal_cp + *residual_heat_capacity_cp) : std::nullopt;
}

std::optional<double> FluidProperties::speed_of_sound() const {
    const auto cp = heat_capacity_cp();
    if (!cp || !(heat_capacity_cv > 0.0)) {
        return std::nullopt;
    }
    return std::sqrt(*cp / heat_capacity_cv * pressure_density_slope);
}

std::optional<double> FluidProperties::isothermal_compressibility() const {
    const double inverse = density * pressure_density_slope;
    return inverse > 0.0 ? std::optional(1.0 / inverse) : std::nullopt;
}

std::optional<double> FluidProperties::thermal_expansion() const {
    const auto compressibility = isothermal_compressibility();
    return compressibility ? std::optional(pressure_temperature_slope * *compressibility) : std::nullopt;
}

std::optional<double> FluidProperties::joule_thomson_coefficient() const {
    const auto cp = heat_capacity_cp();
    return cp ? std::optional(temperature * non_ideal_expansion / (pressure_density_slope * *cp)) : std::nullopt;
}

double second_virial_coefficient(const EquationOfState& equation, double temperature) {
    return residual(equation, temperature, 0.0).derivative(0, 1);
}

std::string outside_of_range(const EquationOfState& equation, const FluidProperties& state) {
    const ValidRange& valid = equation.valid;
    if (state.temperature < valid.lowest_temperature || state.temperature > valid.highest_temperature) {
        return fmt::format("temperature {} is outside of {} to {}, where {} was fitted", state.temperature,
                           valid.lowest_temperature, valid.highest_temperature, equation.name);
    }
    if (valid.highest_density && state.density > *valid.highest_density) {
        return fmt::format("density {} is above {}, up to which {} was fitted", state.density, *valid.highest_density,
                           equation.name);
    }
    if (valid.highest_pressure && state.pressure > *valid.highest_pressure) {
        return fmt::format("pressure {:.6g} is above {}, up to which {} was fitted", state.pressure,
                           *valid.highest_pressure, equation.name);
    }
    return "";
}

}  // namespace ljmd
