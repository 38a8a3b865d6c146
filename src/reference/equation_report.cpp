#include "reference/equation_report.hpp"

#include <fmt/format.h>

#include <fmt/ranges.h>

#include <optional>
#include <utility>
#include <vector>

#include "core/number_text.hpp"
#include "core/text.hpp"
#include "core/text_table.hpp"
#include "ljmd/core/errors.hpp"
#include "reference/equation_doubts.hpp"
#include "reference/near_critical.hpp"

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
            {"isothermal_compressibility", "sigma^3/epsilon", state.isothermal_compressibility()},
            {"thermal_expansion", "k_B/epsilon", state.thermal_expansion()},
            {"joule_thomson_coefficient", "sigma^3/k_B", state.joule_thomson_coefficient()},
            {"residual_heat_capacity_cv", "k_B", state.residual_heat_capacity_cv},
            {"residual_heat_capacity_cp", "k_B", state.residual_heat_capacity_cp},
            {"residual_helmholtz_energy", "epsilon", state.residual_helmholtz_energy},
            {"excess_chemical_potential", "epsilon", state.excess_chemical_potential},
            {"pressure_density_slope", "epsilon", state.pressure_density_slope},
            {"pressure_temperature_slope", "k_B/sigma^3", state.pressure_temperature_slope},
            {"second_virial_coefficient", "sigma^3", second_virial_coefficient(equation, state.temperature)}};
}

std::string number(std::optional<double> value) {
    return value ? fmt::format("{:16.9g}", without_negative_zero(*value)) : fmt::format("{:>16}", "-");
}

std::string heading(const EquationOfState& equation) {
    return fmt::format("{}: {}\n{}\n\n", equation.name, equation.meaning, equation.source);
}

Coexistence coexistence_or_refusal(const EquationOfState& equation, double temperature) {
    auto found = coexistence(equation, temperature);
    if (!found) {
        const double critical = critical_point(equation).temperature;
        if (temperature < critical) {
            throw InputError(too_near_critical("temperature", temperature, equation.name, critical));
        }
        throw InputError(
            fmt::format("temperature {} is not below the critical temperature of {}, {}; above it "
                        "there is one phase: give its density",
                        temperature, equation.name, critical_in_words(temperature, critical)));
    }
    return *found;
}

/// Temperature, density and all lines of a state.
Data state_data(const EquationOfState& equation, const FluidProperties& state) {
    Data data = {{"temperature", state.temperature}, {"density", state.density}};
    for (const auto& [key, unit, value] : lines_of(equation, state)) {
        data[key] = value;
    }
    return data;
}

/// Data of both phases, without the equation's own.
Data coexistence_data(const EquationOfState& equation, const Coexistence& phases) {
    const std::string outside = outside_of_range(equation, phases.liquid);
    return {{"temperature", phases.liquid.temperature},
            {"pressure", phases.pressure},
            {"liquid", state_data(equation, phases.liquid)},
            {"vapour", state_data(equation, phases.vapour)},
            {"heat_of_vaporisation", phases.heat_of_vaporisation()},
            {"warnings", outside.empty() ? Data::list() : Data::list({outside})}};
}

/// What the most stable phase at a pressure is, and which others are metastable there.
void add_phases(Data& data, const EquationOfState& equation, const std::vector<PhaseAtPressure>& phases) {
    data["phase"] = phases.front().name;
    data["metastable"] = Data::list();
    for (std::size_t k = 1; k < phases.size(); ++k) {
        Data other = {{"phase", phases[k].name}, {"gibbs_energy_difference", phases[k].gibbs_energy_difference}};
        other.update(state_data(equation, phases[k].state));
        data["metastable"].push_back(other);
    }
}

/// "metastable: vapour of density 0.0145, its Gibbs energy is higher by 0.0012 epsilon".
std::string metastable_words(const Data& other) {
    return fmt::format("metastable: {} of density {:.6g}, its Gibbs energy is higher by {:.3g} epsilon per atom",
                       other.at("phase").text(), other.at("density").number(),
                       other.at("gibbs_energy_difference").number());
}

Data with_source(const EquationOfState& equation, const Data& data) {
    Data all = {{"model", equation.name}, {"source", equation.source}};
    all.update(data);
    return all;
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

Document coexistence_report(const EquationOfState& equation, const Coexistence& phases) {
    std::string text = heading(equation);
    text += fmt::format("  {:<28}{:>16}{:>18}\n", "coexistence", "liquid", "vapour");
    text += fmt::format("  {:<28}{}{:>2}{}  sigma^-3\n", "density", number(phases.liquid.density), "",
                        number(phases.vapour.density));
    const std::vector<Line> of_vapour = lines_of(equation, phases.vapour);
    std::size_t k = 0;
    for (const auto& [key, unit, value] : lines_of(equation, phases.liquid)) {
        text += fmt::format("  {:<28}{}{:>2}{}  {}\n", key, number(value), "", number(of_vapour[k++].value), unit);
    }
    text +=
        fmt::format("\n  {:<28}{}  epsilon/k_B\n  {:<28}{}  epsilon\n", "temperature",
                    number(phases.liquid.temperature), "heat_of_vaporisation", number(phases.heat_of_vaporisation()));
    return {with_source(equation, coexistence_data(equation, phases)), text};
}

/// A column of the table of many points: the path of its number in the data of a point.
struct TableColumn {
    const char* heading;
    std::vector<const char*> path;
};

const std::vector<TableColumn>& columns_for(bool states) {
    static const std::vector<TableColumn> of_states{{"T", {"temperature"}},        {"rho", {"density"}},
                                                    {"p", {"pressure"}},           {"U/N", {"potential_energy"}},
                                                    {"c_v", {"heat_capacity_cv"}}, {"c_p", {"heat_capacity_cp"}},
                                                    {"w", {"speed_of_sound"}}};
    static const std::vector<TableColumn> of_coexistence{{"T", {"temperature"}},
                                                         {"p", {"pressure"}},
                                                         {"rho_l", {"liquid", "density"}},
                                                         {"rho_v", {"vapour", "density"}},
                                                         {"U_l/N", {"liquid", "potential_energy"}},
                                                         {"U_v/N", {"vapour", "potential_energy"}},
                                                         {"dh_v", {"heat_of_vaporisation"}}};
    return states ? of_states : of_coexistence;
}

std::string entry_of(const Data& point, const TableColumn& column) {
    const Data* found = &point;
    for (const char* key : column.path) {
        found = found == nullptr ? nullptr : found->find(key);
    }
    return found != nullptr && found->is_number() ? fmt::format("{:.6g}", found->number()) : "-";
}

/// What is to be said about a point: why it has no values, other phases, doubts.
std::vector<std::string> remarks_on(const Data& point) {
    std::vector<std::string> remarks;
    if (point.at("failure").is_text()) {
        remarks.push_back(point.at("failure").text());
    }
    if (const Data* others = point.find("metastable")) {
        for (const Data& other : others->items()) {
            remarks.push_back(metastable_words(other));
        }
    }
    if (const Data* warnings = point.find("warnings")) {
        for (const Data& warning : warnings->items()) {
            remarks.push_back(warning.text());
        }
    }
    return remarks;
}

std::string table_text(const EquationOfState& equation, const Data& points, bool states) {
    std::vector<TextTable::Column> headings;
    for (const TableColumn& column : columns_for(states)) {
        headings.push_back({column.heading});
    }
    headings.push_back({"", TextTable::Align::left});
    TextTable table(std::move(headings), 2);
    std::string below;
    std::size_t row = 0;
    for (const Data& point : points.items()) {
        std::vector<std::string> entries;
        entries.reserve(columns_for(states).size() + 1);
        for (const TableColumn& column : columns_for(states)) {
            entries.push_back(entry_of(point, column));
        }
        const std::vector<std::string> remarks = remarks_on(point);
        ++row;
        std::string last = point.contains("phase") ? point.at("phase").text() : "";
        if (!remarks.empty()) {
            last += fmt::format("{}[{}]", last.empty() ? "" : " ", row);
            below += wrapped(fmt::format("  [{}] {}", row, fmt::join(remarks, "; ")), screen_columns, 6) + '\n';
        }
        entries.push_back(last);
        table.add(entries);
    }
    return heading(equation) + table.text() + below;
}

/// The point of a table; if it has no values, with the reason as `failure`.
template <class Values>
Data point_or_failure(Data given, const Values& values) {
    try {
        given.update(values());
        given["failure"] = nullptr;
    } catch (const Error& error) {
        given["failure"] = error.what();
    }
    return given;
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
    Document document{with_source(equation, state_data(equation, state)), heading(equation)};
    document.text += fmt::format("  {:<28}{}  epsilon/k_B\n", "temperature", number(temperature));
    document.text += fmt::format("  {:<28}{}  sigma^-3\n", "density", number(density));
    for (const auto& [key, unit, value] : lines_of(equation, state)) {
        document.text += fmt::format("  {:<28}{}  {}\n", key, number(value), unit);
    }
    document.data["warnings"] = doubts(equation, temperature, density);
    return document;
}

Document coexistence_document(const EquationOfState& equation, double temperature) {
    return coexistence_report(equation, coexistence_or_refusal(equation, temperature));
}

Document saturation_document(const EquationOfState& equation, double pressure) {
    return coexistence_report(equation, coexistence_at_pressure(equation, pressure));
}

Document pressure_document(const EquationOfState& equation, double temperature, double pressure) {
    const std::vector<PhaseAtPressure> phases = states_at_pressure(equation, temperature, pressure);
    Document document = state_document(equation, temperature, phases.front().state.density);
    document.data["pressure"] = pressure;  // without the rounding of the density
    add_phases(document.data, equation, phases);
    document.text += fmt::format("\n  {:<28}{:>16}\n", "phase", phases.front().name);
    for (const Data& other : document.data["metastable"].items()) {
        document.text += "  " + metastable_words(other) + "\n";
    }
    return document;
}

Document points_document(const EquationOfState& equation, const EquationPoints& wanted) {
    const bool states = !wanted.temperatures.empty() && !(wanted.densities.empty() && wanted.pressures.empty());
    Data points = Data::list();
    for (const double temperature : wanted.temperatures) {
        for (const double density : wanted.densities) {
            points.push_back(point_or_failure({{"temperature", temperature}, {"density", density}}, [&] {
                Data data = state_data(equation, properties(equation, temperature, density));
                data["warnings"] = doubts(equation, temperature, density);
                return data;
            }));
        }
        for (const double pressure : wanted.pressures) {
            points.push_back(point_or_failure({{"temperature", temperature}, {"pressure", pressure}}, [&] {
                const auto phases = states_at_pressure(equation, temperature, pressure);
                Data data = state_data(equation, phases.front().state);
                data["pressure"] = pressure;
                add_phases(data, equation, phases);
                data["warnings"] = doubts(equation, temperature, phases.front().state.density);
                return data;
            }));
        }
        if (!states) {
            points.push_back(point_or_failure({{"temperature", temperature}}, [&] {
                return coexistence_data(equation, coexistence_or_refusal(equation, temperature));
            }));
        }
    }
    if (wanted.temperatures.empty()) {
        for (const double pressure : wanted.pressures) {
            points.push_back(point_or_failure({{"pressure", pressure}}, [&] {
                return coexistence_data(equation, coexistence_at_pressure(equation, pressure));
            }));
        }
    }
    std::string text = table_text(equation, points, states);
    return {with_source(equation, {{"points", points}}), std::move(text)};
}

}  // namespace ljmd
