#include "study/reference/reference_property.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "ljmd/core/errors.hpp"

namespace ljmd {

const std::vector<ReferenceProperty>& reference_properties() {
    using State = const FluidProperties&;
    using Number = std::optional<double>;
    static const std::vector<ReferenceProperty> all{
        {"potential_energy", "energy", MeasuredBy::averages, 0.0, [](State s) { return Number(s.potential_energy); }},
        {"pressure", "p", MeasuredBy::averages, 0.0, [](State s) { return Number(s.pressure); }},
        {"compressibility_factor", "Z", MeasuredBy::averages, 0.0,
         [](State s) { return Number(s.compressibility_factor); }},
        {"heat_capacity_cv", "c_v", MeasuredBy::responses, 0.05, [](State s) { return Number(s.heat_capacity_cv); }},
        {"heat_capacity_cp", "c_p", MeasuredBy::responses, 0.05, [](State s) { return s.heat_capacity_cp(); }},
        {"isothermal_compressibility", "kappa_T", MeasuredBy::responses, 0.05,
         [](State s) { return s.isothermal_compressibility(); }},
        {"thermal_expansion", "alpha_p", MeasuredBy::responses, 0.05, [](State s) { return s.thermal_expansion(); }},
        {"thermal_pressure_coefficient", "gamma_V", MeasuredBy::responses, 0.05,
         [](State s) { return Number(s.pressure_temperature_slope); }},
        {"speed_of_sound", "w", MeasuredBy::responses, 0.05, [](State s) { return s.speed_of_sound(); }},
        {"joule_thomson_coefficient", "mu_JT", MeasuredBy::responses, 0.0,
         [](State s) { return s.joule_thomson_coefficient(); }},
        {"excess_chemical_potential", "mu_ex", MeasuredBy::insertion, 0.0,
         [](State s) { return Number(s.excess_chemical_potential); }},
        {"rdf", "g", MeasuredBy::structure, 0.0, nullptr},
        {"structure_factor", "S", MeasuredBy::structure, 0.0, nullptr},
        {"diffusion", "D", MeasuredBy::transport, 0.1, nullptr},
        {"viscosity", "eta", MeasuredBy::transport, 0.1, nullptr},
        {"bulk_viscosity", "eta_v", MeasuredBy::transport, 0.15, nullptr},
        {"thermal_conductivity", "lambda", MeasuredBy::transport, 0.1, nullptr}};
    return all;
}

const ReferenceProperty& reference_property(const std::string& name) {
    const auto& all = reference_properties();
    const auto found = std::ranges::find_if(
        all, [&](const ReferenceProperty& property) { return name == property.name || name == property.alias; });
    if (found == all.end()) {
        std::vector<std::string> names;
        names.reserve(all.size());
        for (const ReferenceProperty& property : all) {
            names.push_back(fmt::format("{} ({})", property.name, property.alias));
        }
        throw InputError(fmt::format("unknown property '{}', allowed: {}", name, fmt::join(names, ", ")));
    }
    return *found;
}

std::optional<double> value_by_equation(const ReferenceProperty& property, const FluidProperties& state) {
    return property.by_equation == nullptr ? std::nullopt : property.by_equation(state);
}

}  // namespace ljmd
