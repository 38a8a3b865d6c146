#include "ljmd/report/quantity_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace ljmd {

namespace {

struct Named {
    std::string_view name;
    std::string_view symbol;
    std::string_view unit;
};

constexpr std::array<Named, 61> known{{{"time", "t", "tau"},
                                       {"temperature", "T", "epsilon/k_B"},
                                       {"potential_energy", "U/N", "epsilon"},
                                       {"kinetic_energy", "K/N", "epsilon"},
                                       {"total_energy", "E/N", "epsilon"},
                                       {"conserved_energy", "E/N - Q/N", "epsilon"},
                                       {"external_energy", "U_ext/N", "epsilon"},
                                       {"pressure", "p", "epsilon/sigma^3"},
                                       {"pressure_xx", "p_xx", "epsilon/sigma^3"},
                                       {"pressure_yy", "p_yy", "epsilon/sigma^3"},
                                       {"pressure_zz", "p_zz", "epsilon/sigma^3"},
                                       {"pressure_xy", "p_xy", "epsilon/sigma^3"},
                                       {"pressure_xz", "p_xz", "epsilon/sigma^3"},
                                       {"pressure_yz", "p_yz", "epsilon/sigma^3"},
                                       {"virial", "W", "epsilon"},
                                       {"density", "rho", "sigma^-3"},
                                       {"compressibility_factor", "Z", ""},
                                       {"heat_capacity_cv", "c_v", "k_B"},
                                       {"heat_capacity_cp", "c_p", "k_B"},
                                       {"isothermal_compressibility", "kappa_T", "sigma^3/epsilon"},
                                       {"adiabatic_compressibility", "kappa_S", "sigma^3/epsilon"},
                                       {"thermal_expansion", "alpha_p", "k_B/epsilon"},
                                       {"thermal_pressure_coefficient", "gamma_V", "k_B/sigma^3"},
                                       {"speed_of_sound", "w", "sigma/tau"},
                                       {"joule_thomson_coefficient", "mu_JT", "sigma^3/k_B"},
                                       {"configurational_temperature", "T_conf", "epsilon/k_B"},
                                       {"order_parameter", "order", ""},
                                       {"coordination_number", "n_c", ""},
                                       {"diffusion", "D", "sigma^2/tau"},
                                       {"diffusion_green_kubo", "D_GK", "sigma^2/tau"},
                                       {"diffusion_infinite_system", "D_inf", "sigma^2/tau"},
                                       {"viscosity", "eta", "epsilon tau/sigma^3"},
                                       {"bulk_viscosity", "eta_v", "epsilon tau/sigma^3"},
                                       {"thermal_conductivity", "lambda", "k_B/(sigma tau)"},
                                       {"excess_chemical_potential", "mu_ex", "epsilon"},
                                       {"surface_tension", "gamma", "epsilon/sigma^2"},
                                       {"normal_pressure", "p_N", "epsilon/sigma^3"},
                                       {"tangential_pressure", "p_T", "epsilon/sigma^3"},
                                       {"liquid_density", "rho_l", "sigma^-3"},
                                       {"vapour_density", "rho_v", "sigma^-3"},
                                       {"z", "z", "sigma"},
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
                                       {"pressure_autocorrelation", "<dp(0) dp(t)>", "epsilon^2/sigma^6"},
                                       {"heat_flux_autocorrelation", "<J(0) J(t)>", "epsilon^2/(sigma^4 tau^2)"},
                                       {"step", "step", ""},
                                       {"seconds", "wall time", "s"},
                                       {"Z", "Z", ""},
                                       {"U", "U/N", "epsilon"},
                                       {"rho", "rho", "sigma^-3"},
                                       {"T", "T", "epsilon/k_B"},
                                       {"length", "block length", "samples"},
                                       {"energy_change", "change of E/N", "epsilon"}}};

const Named* find_named(std::string_view name) {
    const auto* found = std::ranges::find(known, name, &Named::name);
    return found == known.end() ? nullptr : found;
}

}  // namespace

PageColumn described(const std::string& column) {
    static constexpr std::string_view error = "_standard_error";
    if (column.ends_with(error)) {
        PageColumn of = described(column.substr(0, column.size() - error.size()));
        return {column, fmt::format("error of {}", of.label), of.unit};
    }
    const Named* found = find_named(column);
    return found == nullptr ? PageColumn{column, in_plain_words(column)}
                            : PageColumn{column, std::string(found->symbol), std::string(found->unit)};
}

std::string symbol_of(const std::string& observable) {
    const Named* found = find_named(observable);
    return found == nullptr ? "" : std::string(found->symbol);
}

std::string axis_label(const std::string& column) {
    const PageColumn of = described(column);
    const bool compound = of.unit.find_first_of(" /") != std::string::npos;
    return of.unit.empty() ? of.label
           : compound      ? fmt::format("{} / ({})", of.label, of.unit)
                           : fmt::format("{} / {}", of.label, of.unit);
}

std::string in_plain_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string as_title(const std::string& name) {
    std::string words = in_plain_words(name);
    if (!words.empty()) {
        words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    }
    return words;
}

}  // namespace ljmd
