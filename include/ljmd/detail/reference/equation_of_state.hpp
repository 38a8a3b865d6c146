#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/core/taylor.hpp"

namespace ljmd {

/// Range in which an equation of state was fitted to data, in reduced units.
struct ValidRange {
    double lowest_temperature;
    double highest_temperature;
    std::optional<double> highest_density{};
    std::optional<double> highest_pressure{};
};

/// Equation of state of a Lennard-Jones fluid: the residual Helmholtz energy as a function of temperature and density.
/// In reduced units (sigma = epsilon = m = k_B = 1), with energies per atom.
struct EquationOfState {
    std::string name;     ///< as users write it
    std::string meaning;  ///< authors and fluid
    std::string source;   ///< publication
    bool full_potential;  ///< for the fluid without truncation of the potential
    ValidRange valid;

    /// A_res/(N k_B T) as a function of T and rho, where A_res is the Helmholtz energy minus the ideal gas's at the
    /// same temperature and density. @pre T > 0, rho >= 0
    std::function<Taylor(const Taylor& temperature, const Taylor& density)> residual_helmholtz;
};

/// All equations of state. Each is one file in src/reference/equations.
[[nodiscard]] std::vector<EquationOfState> all_equations_of_state();

/// Properties of one phase at a temperature and a density, from a = A_res/(N k_B T):
///
///     Z    = 1 + rho a_rho                        p = rho T Z
///     u    = -T^2 a_T                             c_v = 3/2 - 2 T a_T - T^2 a_TT
///     mu_x = T (a + rho a_rho)                    dp/drho = T (1 + 2 rho a_rho + rho^2 a_rhorho)
///     dp/dT = rho (1 + rho a_rho + T rho a_Trho)  c_p = c_v + T (dp/dT)^2 / (rho^2 dp/drho)
///     w^2  = c_p/c_v dp/drho                      kappa_T = 1/(rho dp/drho)
///     alpha_p = (dp/dT)/(rho dp/drho)             mu_JT = (dT/dp)_h = (T alpha_p - 1)/(rho c_p)
///
/// What is divided by dp/drho is empty where that is not positive, because no phase is stable there, and at zero
/// density. Source: R. Span, Multiparameter Equations of State (2000), chapter 3.
struct FluidProperties {
    double temperature;
    double density;
    double compressibility_factor;      ///< Z
    double pressure;                    ///< p
    double potential_energy;            ///< u, without the kinetic energy
    double heat_capacity_cv;            ///< c_v, including 3/2 from the kinetic energy
    double residual_heat_capacity_cv;   ///< c_v - 3/2, to all digits at any low density
    double residual_helmholtz_energy;   ///< A_res/N
    double excess_chemical_potential;   ///< mu_x, relative to the ideal gas at the same density
    double pressure_density_slope;      ///< dp/drho at constant T; 1/(rho kappa_T). Negative if no phase is stable
    double pressure_temperature_slope;  ///< dp/dT at constant density
    double pressure_density_curvature;  ///< d2p/drho2 at constant T
    double non_ideal_expansion;         ///< (T dp/dT/rho - dp/drho)/(rho T) = T a_Trho - a_rho - rho a_rhorho

    /// c_p - 5/2, to all digits at any low density, where it becomes -rho T^2 d2B2/dT2. With b = rho a_rho + T rho
    /// a_Trho:
    ///
    ///     c_p - 5/2 = c_v - 3/2 + (2 T rho a_Trho - rho^2 a_rhorho + b^2) / (1 + 2 rho a_rho + rho^2 a_rhorho)
    std::optional<double> residual_heat_capacity_cp;

    [[nodiscard]] std::optional<double> heat_capacity_cp() const;  ///< c_p
    [[nodiscard]] std::optional<double> speed_of_sound() const;    ///< w

    [[nodiscard]] std::optional<double> isothermal_compressibility() const;  ///< kappa_T
    [[nodiscard]] std::optional<double> thermal_expansion() const;           ///< alpha_p

    /// mu_JT. To all digits at any low density, where T alpha_p is nearly 1: it becomes (T dB2/dT - B2)/(5/2).
    [[nodiscard]] std::optional<double> joule_thomson_coefficient() const;
};

/// The equation with this name. @throws InputError listing all names, if there is none
[[nodiscard]] EquationOfState equation_of_state(const std::string& name);

/// @pre temperature > 0, density >= 0, within the domain of the formula
/// @throws PhysicsError if the equation gives no finite pressure or energy
[[nodiscard]] FluidProperties properties(const EquationOfState& equation, double temperature, double density);

/// Second virial coefficient [sigma^3] of the equation: a_rho at zero density. @pre temperature > 0
[[nodiscard]] double second_virial_coefficient(const EquationOfState& equation, double temperature);

/// Why a state is outside of the range of the fit; empty if it is inside.
[[nodiscard]] std::string outside_of_range(const EquationOfState& equation, const FluidProperties& state);

}  // namespace ljmd
