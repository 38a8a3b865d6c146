#include "ljmd/reference/equation_report.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/reference/equation_doubts.hpp"

namespace ljmd {

namespace {

/// A number with its key in JSON and in tables, and its unit.
struct Line {
    const char* key;
    const char* unit;
    std::optional<double> value;
};

std::vector<Line> lines_of(const EquationOfState& equation, const FluidProperties& state) {
    return {{"compressibility_factor", "1", state.compressibility_factor},
            {"pressure", "epsilon/sigma^3", state.pressure},
            {"potential_energy", "epsilon", state.potential_energy},
            {"heat_capacity_cv", "k_B", state.heat_capacity_cv},
            {"heat_capacity_cp", "k_B", state.heat_capacity_cp()},
            {"speed_of_sound", "sqrt(epsilon/m)", state.speed_of_sound()},
            {"residual_helmholtz_energy", "epsilon", state.residual_helmholtz_energy},
            {"excess_chemical_potential", "epsilon", state.excess_chemical_potential},
            {"pressure_density_slope", "epsilon", state.pressure_density_slope},
            {"pressure_temperature_slope", "k_B/sigma^3", state.pressure_temperature_slope},
            {"second_virial_coefficient", "sigma^3", second_virial_coefficient(equation, state.temperature)}};
}

std::string number(std::optional<double> value) {
    return value ? fmt::format("{:16.9g}", *value) : fmt::format("{:>16}", "-");
}

std::string heading(const EquationOfState& equation) {
    return fmt::format("{}: {}\n{}\n\n", equation.name, equation.meaning, equation.source);
}

Coexistence coexistence_or_refusal(const EquationOfState& equation, double temperature) {
    auto found = coexistence(equation, temperature);
    if (!found) {
        throw InputError(
            fmt::format("temperature {} is not below the critical temperature of {}, {:.6g}; above it "
                        "there is one phase: give its density",
                        temperature, equation.name, critical_point(equation).temperature));
    }
    return *found;
}

std::string range_of(const ValidRange& valid) {
    std::string text = fmt::format("T {} to {}", valid.lowest_temperature, valid.highest_temperature);
    if (valid.highest_density) {
        text += fmt::format(", rho <= {}", *valid.highest_density);
    }
    if (valid.highest_pressure) {
        text += fmt::format(", p <= {}", *valid.highest_pressure);
    }
    return text;
}

}  // namespace

Document equations_document() {
    Document document{Data::list(), fmt::format("{:<20}{:>10}{:>10}{:>10}   {:<32}{}\n", "model", "T_c", "rho_c", "p_c",
                                                "fitted to", "of")};
    for (const EquationOfState& equation : all_equations_of_state()) {
        const CriticalPoint point = critical_point(equation);
        document.text += fmt::format("{:<20}{:>10.4f}{:>10.4f}{:>10.5f}   {:<32}{}\n", equation.name, point.temperature,
                                     point.density, point.pressure, range_of(equation.valid), equation.meaning);
        document.data.push_back({{"model", equation.name},
                                 {"meaning", equation.meaning},
                                 {"source", equation.source},
                                 {"lowest_temperature", equation.valid.lowest_temperature},
                                 {"highest_temperature", equation.valid.highest_temperature},
                                 {"highest_density", equation.valid.highest_density},
                                 {"highest_pressure", equation.valid.highest_pressure},
                                 {"critical_temperature", point.temperature},
                                 {"critical_density", point.density},
                                 {"critical_pressure", point.pressure}});
    }
    return document;
}

Document state_document(const EquationOfState& equation, double temperature, double density) {
    const FluidProperties state = properties(equation, temperature, density);
    Document document{{{"model", equation.name},
                       {"source", equation.source},
                       {"temperature", state.temperature},
                       {"density", state.density}},
                      heading(equation)};
    document.text += fmt::format("  {:<28}{}  epsilon/k_B\n", "temperature", number(temperature));
    document.text += fmt::format("  {:<28}{}  sigma^-3\n", "density", number(density));
    for (const auto& [key, unit, value] : lines_of(equation, state)) {
        document.data[key] = value;
        document.text += fmt::format("  {:<28}{}  {}\n", key, number(value), unit);
    }
    document.data["warnings"] = doubts(equation, temperature, density);
    return document;
}

Document coexistence_document(const EquationOfState& equation, double temperature) {
    const Coexistence phases = coexistence_or_refusal(equation, temperature);
    Data liquid = {{"temperature", phases.liquid.temperature}, {"density", phases.liquid.density}};
    Data vapour = {{"temperature", phases.vapour.temperature}, {"density", phases.vapour.density}};
    std::string text = heading(equation);
    text += fmt::format("  {:<28}{:>16}{:>18}\n", "coexistence", "liquid", "vapour");
    text += fmt::format("  {:<28}{}{:>2}{}  sigma^-3\n", "density", number(phases.liquid.density), "",
                        number(phases.vapour.density));
    const std::vector<Line> of_vapour = lines_of(equation, phases.vapour);
    std::size_t k = 0;
    for (const auto& [key, unit, value] : lines_of(equation, phases.liquid)) {
        const std::optional<double> other = of_vapour[k++].value;
        liquid[key] = value;
        vapour[key] = other;
        text += fmt::format("  {:<28}{}{:>2}{}  {}\n", key, number(value), "", number(other), unit);
    }
    text += fmt::format("\n  {:<28}{}  epsilon/k_B\n  {:<28}{}  epsilon\n", "temperature", number(temperature),
                        "heat_of_vaporisation", number(phases.heat_of_vaporisation()));
    return {{{"model", equation.name},
             {"source", equation.source},
             {"temperature", temperature},
             {"pressure", phases.pressure},
             {"liquid", liquid},
             {"vapour", vapour},
             {"heat_of_vaporisation", phases.heat_of_vaporisation()}},
            text};
}

}  // namespace ljmd
