#include "ljmd/observables/statistics/known_quantities.hpp"

#include <algorithm>

namespace ljmd {

namespace {

/// Columns and results that no sample of a fluid has.
constexpr std::array<SampledQuantity, 63> others{
    {{"time", "t", "tau"},
     {"conserved_energy", "E/N - Q/N", "epsilon"},
     {"external_energy", "U_ext/N", "epsilon"},
     {"compressibility_factor", "Z", ""},
     {"heat_capacity_cv", "c_v", "k_B"},
     {"order_parameter", "order", ""},
     {"coordination_number", "n_c", ""},
     {"diffusion", "D", "sigma^2/tau"},
     {"diffusion_green_kubo", "D_GK", "sigma^2/tau"},
     {"diffusion_infinite_system", "D_inf", "sigma^2/tau"},
     {"viscosity", "eta", "epsilon tau/sigma^3"},
     {"excess_chemical_potential", "mu_ex", "epsilon"},
     {"heat_capacity_cp", "c_p", "k_B"},
     {"isothermal_compressibility", "kappa_T", "sigma^3/epsilon"},
     {"adiabatic_compressibility", "kappa_S", "sigma^3/epsilon"},
     {"thermal_expansion", "alpha_p", "k_B/epsilon"},
     {"thermal_pressure_coefficient", "gamma_V", "k_B/sigma^3"},
     {"speed_of_sound", "w", "sigma/tau"},
     {"joule_thomson_coefficient", "mu_JT", "sigma^3/k_B"},
     {"configurational_temperature", "T_conf", "epsilon/k_B"},
     {"bulk_viscosity", "eta_v", "epsilon tau/sigma^3"},
     {"thermal_conductivity", "lambda", "k_B/(sigma tau)"},
     {"cutoff_energy", "du_c", "epsilon"},
     {"cutoff_pressure", "dp_c", "epsilon/sigma^3"},
     {"cutoff_energy_response", "du_r", "epsilon"},
     {"cutoff_pressure_response", "dp_r", "epsilon/sigma^3"},
     {"surface_tension", "gamma", "epsilon/sigma^2"},
     {"normal_pressure", "p_N", "epsilon/sigma^3"},
     {"tangential_pressure", "p_T", "epsilon/sigma^3"},
     {"liquid_density", "rho_l", "sigma^-3"},
     {"vapour_density", "rho_v", "sigma^-3"},
     {"z", "z", "sigma"},
     {"edge_x", "L_x", "sigma"},
     {"edge_y", "L_y", "sigma"},
     {"edge_z", "L_z", "sigma"},
     {"site_displacement", "<u^2>", "sigma^2"},
     {"site_displacement_debye_waller", "<u^2>_DW", "sigma^2"},
     {"lindemann_ratio", "<u^2>^(1/2)/d", ""},
     {"debye_waller_factor", "exp(-2 W)", ""},
     {"debye_waller_gaussian", "exp(-k^2 <u^2>/3)", ""},
     {"vacant_sites", "vacant", ""},
     {"bragg_peak", "S(k_1)/N", ""},
     {"vectors", "vectors", ""},
     {"pressure_autocorrelation", "<dp(0) dp(t)>", "epsilon^2/sigma^6"},
     {"heat_flux_autocorrelation", "<J(0) J(t)>", "epsilon^2/(sigma^4 tau^2)"},
     {"r", "r", "sigma"},
     {"g", "g(r)", ""},
     {"k", "k sigma", ""},
     {"S", "S(k)", ""},
     {"msd", "<dr^2>", "sigma^2"},
     {"vacf", "<v(0) v(t)>", "sigma^2/tau^2"},
     {"vacf_normalized", "<v(0) v(t)>/<v^2>", ""},
     {"angular_frequency", "omega tau", ""},
     {"spectrum", "spectrum", ""},
     {"stress_autocorrelation", "<s(0) s(t)>", "epsilon^2/sigma^6"},
     {"step", "step", ""},
     {"seconds", "wall time", "s"},
     {"Z", "Z", ""},
     {"U", "U/N", "epsilon"},
     {"rho", "rho", "sigma^-3"},
     {"T", "T", "epsilon/k_B"},
     {"length", "block length", "samples"},
     {"energy_change", "change of E/N", "epsilon"}}};

}  // namespace

const SampledQuantity* find_quantity(std::string_view name) {
    const auto is_it = [name](const SampledQuantity& quantity) { return quantity.name == name; };
    const auto* sampled = std::ranges::find_if(sampled_quantities, is_it);
    if (sampled != sampled_quantities.end()) {
        return sampled;
    }
    const auto* other = std::ranges::find_if(others, is_it);
    return other == others.end() ? nullptr : other;
}

std::string symbol_of(std::string_view observable) {
    const SampledQuantity* found = find_quantity(observable);
    return found == nullptr ? "" : found->symbol;
}

}  // namespace ljmd
