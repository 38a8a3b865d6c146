#include "study/reference/reference_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "engine/result_doubts.hpp"
#include "ljmd/core/build_info.hpp"
#include "study/error_in_brackets.hpp"

namespace ljmd {

namespace {

Data data_of(const ReferenceValue& value) {
    Data equations = Data::object();
    for (const auto& [name, number] : value.by_equations) {
        equations[name] = number;
    }
    const auto thol = std::ranges::find(value.by_equations, "thol2016", &std::pair<std::string, double>::first);
    Data data = {
        {"mean", value.mean},
        {"statistical_error", value.statistical_error},
        {"systematic_error", value.systematic_error},
        {"total_error", value.total_error()},
        {"cutoff_correction", value.cutoff_correction},
        {"size_correction", value.size_correction},
        {"independent_samples", value.independent},
        {"error_is_converged", value.converged && value.mean.has_value()},
        {"equation_of_state", thol == value.by_equations.end() ? std::optional<double>() : std::optional(thol->second)},
        {"equations_of_state", equations},
        {"unit", value.unit}};
    if (!value.remark.empty()) {
        data["remark"] = value.remark;
    }
    return data;
}

Data data_of(const ReferenceRuns& runs) {
    return {{"steps", runs.steps}, {"time_step", runs.time_step}};
}

Data data_of(const PhaseOfState& phase) {
    Data data = {
        {"saturated_vapour", nullptr}, {"saturated_liquid", nullptr}, {"freezing", nullptr}, {"melting", nullptr}};
    if (phase.saturation) {
        data["saturated_vapour"] = phase.saturation->vapour.density;
        data["saturated_liquid"] = phase.saturation->liquid.density;
    }
    if (phase.freezing) {
        data["freezing"] = phase.freezing->freezing;
        data["melting"] = phase.freezing->melting;
    }
    return data;
}

/// What a reader must know before the numbers are used.
std::vector<std::string> warnings_of(const ReferenceSetup& setup, const ReferenceFindings& findings) {
    std::vector<std::string> warnings = setup.remarks;
    for (const ReachedError& one : findings.errors) {
        if (!one.reached && std::isnan(one.wanted.error)) {
            warnings.push_back(
                fmt::format("there is no value of {}: --max-steps ended the runs before they were long "
                            "enough",
                            one.wanted.observable));
        } else if (!one.reached && one.error <= one.wanted.error) {
            warnings.push_back(
                fmt::format("the statistical error of {} does not count yet: the runs are too short to know "
                            "it, and --max-steps ended them",
                            one.wanted.observable));
        } else if (!one.reached) {
            warnings.push_back(
                fmt::format("the statistical error of {} is {:.2g}, not {:.2g}: --max-steps ended the "
                            "runs before it was reached",
                            one.wanted.observable, one.error, one.wanted.error));
        }
    }
    for (const ReferenceValue& value : findings.values) {
        const auto wanted = std::ranges::find_if(
            findings.errors, [&](const ReachedError& one) { return one.wanted.observable == value.name; });
        if (wanted != findings.errors.end() && value.systematic_error > wanted->wanted.error) {
            warnings.push_back(
                fmt::format("the systematic error of {}, {:.2g}, is larger than the error wanted: longer "
                            "runs hardly make it smaller, more atoms do",
                            value.name, value.systematic_error));
        }
        if (value.mean && !value.converged) {
            warnings.push_back(
                fmt::format("the statistical error of {} is a guess: the runs are too short for it", value.name));
        }
    }
    if (std::abs(findings.halves) > largest_difference_of_halves) {
        warnings.push_back(
            fmt::format("the energy changes in the course of the runs, by {:.1f} of its standard errors between their "
                        "halves: the fluid is not in equilibrium, or changes its phase, and these are not its values",
                        findings.halves));
    }
    if (findings.order.value_or(0.0) > largest_molten_order(setup.atoms)) {
        warnings.push_back(
            fmt::format("the crystal of the start has not melted (translational order {:.3f})", *findings.order));
    }
    warnings.insert(warnings.end(), findings.warnings.begin(), findings.warnings.end());
    return warnings;
}

std::string citation(const ReferenceSetup& setup, const ReferenceFindings& findings) {
    const ReferenceRequest& request = setup.request;
    std::string text = fmt::format(
        "Values of the Lennard-Jones fluid, u = 4 epsilon [(sigma/r)^12 - (sigma/r)^6] without cutoff, at T = {} "
        "epsilon/k_B and rho = {:.10g} sigma^-3 ({}), computed with ljmd {} ({}): {} independent runs of {} atoms in "
        "the "
        "canonical ensemble (Langevin thermostat BAOAB, time step {:.4g} tau), {} steps each after {} of "
        "equilibration; seed {}. ",
        request.temperature, setup.density, name_of(setup.phase.phase), build_info().version,
        build_info().commit.substr(0, 10), request.replicas, setup.atoms, findings.canonical.time_step,
        findings.canonical.steps, findings.equilibration, request.seed);
    if (findings.transport) {
        text += fmt::format(
            "Transport from {} runs at constant energy, {} steps of {:.4g} tau each (Green and Kubo; "
            "diffusion by Einstein's relation, corrected for the box after Yeh and Hummer 2004). ",
            request.replicas, findings.transport->steps, findings.transport->time_step);
    }
    text += fmt::format(
        "The potential was switched off from {} to {} sigma; energy and pressure are corrected to no "
        "cutoff by pairs up to {:.4g} sigma and a tail with g = 1 beyond, to first order with the "
        "response of the structure, and to infinite size by terms of order 1/N from the equation of "
        "state of Thol et al. 2016. Errors are one standard deviation.",
        setup.potential.cutoff().switch_start, setup.potential.cutoff().radius, setup.counted_radius());
    return text;
}

std::string error_text(double error) {
    return std::isfinite(error) ? fmt::format("{:.2g}", error) : "?";
}

std::string number_text(const ReferenceValue& value, std::string_view equation) {
    const auto found = std::ranges::find(value.by_equations, equation, &std::pair<std::string, double>::first);
    return found == value.by_equations.end() ? "-" : fmt::format("{:.5g}", found->second);
}

TextTable table_of(const ReferenceFindings& findings) {
    TextTable table({{"property", TextTable::Align::left},
                     {"", TextTable::Align::left},
                     {"value"},
                     {"statistical"},
                     {"systematic"},
                     {"thol2016"},
                     {"unit", TextTable::Align::left}},
                    2);
    const auto add = [&](const ReferenceValue& value) {
        const double error = std::isfinite(value.total_error()) ? value.total_error() : value.statistical_error;
        table.add({value.name, value.symbol, value.mean ? with_error_in_brackets(*value.mean, error) : "no value",
                   error_text(value.statistical_error), error_text(value.systematic_error),
                   number_text(value, "thol2016"), value.unit});
    };
    if (findings.density) {
        add(*findings.density);
    }
    std::ranges::for_each(findings.values, add);
    return table;
}

}  // namespace

Document reference_report(const ReferenceSetup& setup, const ReferenceFindings& findings,
                          std::optional<std::size_t> screen) {
    const std::vector<std::string> warnings = warnings_of(setup, findings);
    const std::string cited = citation(setup, findings);
    Data data = {{"kind", "reference"},
                 {"temperature", setup.request.temperature},
                 {"density_of_runs", setup.density},
                 {"phase", name_of(setup.phase.phase)},
                 {"phase_diagram", data_of(setup.phase)},
                 {"translational_order", findings.order}};
    data["density"] = findings.density ? data_of(*findings.density) : Data(setup.density);
    if (setup.request.pressure) {
        data["asked_pressure"] = *setup.request.pressure;
    }
    for (const ReferenceValue& value : findings.values) {
        data[value.name] = data_of(value);
    }
    Data errors = Data::object();
    for (const ReachedError& one : findings.errors) {
        errors[one.wanted.observable] = {{"wanted", one.wanted.error}, {"error", one.error}, {"reached", one.reached}};
    }
    data["errors"] = errors;
    data["runs"] = {{"atoms", setup.atoms},
                    {"replicas", setup.request.replicas},
                    {"seed", setup.request.seed},
                    {"cutoff", setup.potential.cutoff().radius},
                    {"switch_start", setup.potential.cutoff().switch_start},
                    {"counted_radius", setup.counted_radius()},
                    {"equilibration_steps", findings.equilibration},
                    {"equilibration_found", findings.pilot.rows * rows_every},
                    {"statistical_inefficiency", findings.pilot.inefficiency * static_cast<double>(rows_every)},
                    {"difference_of_halves", findings.halves},
                    {"canonical", data_of(findings.canonical)},
                    {"transport", findings.transport ? data_of(*findings.transport) : Data()}};
    data["warnings"] = warnings;
    data["citation"] = cited;

    const std::size_t columns = screen.value_or(screen_columns);
    const TextTable table = table_of(findings);
    const std::string lines = setup.phase.lines();
    std::string text =
        wrapped(fmt::format("Lennard-Jones fluid at T = {}, {}: {}{}", setup.request.temperature,
                            setup.request.pressure
                                ? fmt::format("p = {} (runs at rho = {:.6g})", *setup.request.pressure, setup.density)
                                : fmt::format("rho = {}", setup.density),
                            name_of(setup.phase.phase), lines.empty() ? "" : fmt::format(" ({})", lines)),
                columns, 2);
    text += "\n\n" + (screen ? table.text_within(*screen) : table.text());
    text += wrapped("  in brackets both errors together, in the last digits, as far as they are known; ?: not assessed",
                    columns, 4);
    text += '\n';
    for (const ReferenceValue& value : findings.values) {
        if (!value.remark.empty()) {
            text += wrapped(fmt::format("  {}: {}", value.name, value.remark), columns, 4) + '\n';
        }
    }
    for (const std::string& warning : warnings) {
        text += wrapped("  warning: " + warning, columns, 4) + '\n';
    }
    text += "\nto cite:\n" + wrapped("  " + cited, columns, 2) + '\n';
    return {data, text};
}

}  // namespace ljmd
