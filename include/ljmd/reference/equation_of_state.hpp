#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/taylor.hpp"

namespace ljmd {

/// Where an equation of state was fitted to data. In reduced units.
struct ValidRange {
    double lowest_temperature;
    double highest_temperature;
    std::optional<double> highest_density{};
    std::optional<double> highest_pressure{};
};

/// An equation of state of a Lennard-Jones fluid: the residual Helmholtz energy as a function of temperature and
/// density. In reduced units (sigma = epsilon = m = k_B = 1), all energies per atom.
struct EquationOfState {
    std::string name;     ///< as users write it
    std::string meaning;  ///< whose equation, of which fluid
    std::string source;   ///< where it was published
    bool full_potential;  ///< of the fluid whose potential is not truncated
    ValidRange valid;

    /// A_res/(N k_B T) as a function of T and rho; A_res is the Helmholtz energy less that of the ideal gas at the same
    /// temperature and density. @pre T > 0, rho >= 0
    std::function<Taylor(const Taylor& temperature, const Taylor& density)> residual_helmholtz;
};

/// Every equation of state that there is. Adding one is adding a file in src/reference/equations.
[[nodiscard]] std::vector<EquationOfState> all_equations_of_state();

/// What an equation of state says of one phase at a temperature and a density, a = A_res/(N k_B T):
///
///     Z    = 1 + rho a_rho                        p = rho T Z
///     u    = -T^2 a_T                             c_v = 3/2 - 2 T a_T - T^2 a_TT
///     mu_x = T (a + rho a_rho)                    dp/drho = T (1 + 2 rho a_rho + rho^2 a_rhorho)
///     dp/dT = rho (1 + rho a_rho + T rho a_Trho)  c_p = c_v + T (dp/dT)^2 / (rho^2 dp/drho)
///     w^2  = c_p/c_v dp/drho
///
/// Source: R. Span, Multiparameter Equations of State (2000), chapter 3.
struct FluidProperties {
    double temperature;
    double density;
    double compressibility_factor;      ///< Z
    double pressure;                    ///< p
    double potential_energy;            ///< u, without kinetic energy
    double heat_capacity_cv;            ///< with the 3/2 of the kinetic energy
    double residual_helmholtz_energy;   ///< A_res/N
    double excess_chemical_potential;   ///< mu_x: what inserting an atom costs beyond the ideal gas at that density
    double pressure_density_slope;      ///< dp/drho at constant T; 1/(rho kappa_T). Negative where no phase is stable
    double pressure_temperature_slope;  ///< dp/dT at constant density
    double pressure_density_curvature;  ///< d2p/drho2 at constant T

    /// c_p; none where no phase is stable, or at zero density.
    [[nodiscard]] std::optional<double> heat_capacity_cp() const;

    /// w, the speed of sound; none where no phase is stable, or at zero density.
    [[nodiscard]] std::optional<double> speed_of_sound() const;
};

/// The one of that name. @throws InputError, naming those there are
[[nodiscard]] EquationOfState equation_of_state(const std::string& name);

/// @pre temperature > 0, density >= 0; not beyond what the formula can take
/// @throws PhysicsError where the equation gives no finite pressure
[[nodiscard]] FluidProperties properties(const EquationOfState& equation, double temperature, double density);

/// The second virial coefficient [sigma^3] that it implies: a_rho at density zero. @pre temperature > 0
[[nodiscard]] double second_virial_coefficient(const EquationOfState& equation, double temperature);

/// Why a state lies outside of what the equation was fitted to; empty where it lies inside.
[[nodiscard]] std::string outside_of_range(const EquationOfState& equation, const FluidProperties& state);

}  // namespace ljmd
