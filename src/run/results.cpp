#include "run/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "run/footnotes.hpp"
#include "run/run_report.hpp"

namespace ljmd {

namespace {

/// The unit of an observable for a substance.
struct SiUnit {
    double factor;
    std::string name;
};

std::optional<SiUnit> si_unit(const std::string& reduced, const std::optional<SubstanceUnits>& units) {
    if (!units) {
        return std::nullopt;
    }
    if (reduced == "epsilon/k_B") {
        return SiUnit{units->kelvin(), "K"};
    }
    if (reduced == "epsilon") {
        return SiUnit{units->kilojoule_per_mole(), "kJ/mol"};
    }
    if (reduced == "epsilon/sigma^3") {
        return SiUnit{units->bar(), "bar"};
    }
    if (reduced == "k_B") {
        return SiUnit{1e3 * units->kilojoule_per_mole() / units->kelvin(), "J/(mol K)"};
    }
    if (reduced == "sigma^2/tau") {
        return SiUnit{1e3 * units->nanometre() * units->nanometre() / units->picosecond(), "nm^2/ns"};
    }
    if (reduced == "epsilon tau/sigma^3") {
        return SiUnit{1e-4 * units->bar() * units->picosecond(), "mPa s"};
    }
    if (reduced == "k_B/(sigma tau)") {
        const double square = units->nanometre() * units->nanometre();
        return SiUnit{1e2 * units->bar() * square / (units->kelvin() * units->picosecond()), "mW/(m K)"};
    }
    return std::nullopt;
}

Data estimate_data(const ObservableAverage& average, const std::optional<SubstanceUnits>& units) {
    if (!average.estimate) {
        return {
            {"mean", nullptr}, {"standard_error", nullptr}, {"independent_samples", nullptr}, {"unit", average.unit}};
    }
    const Estimate& e = *average.estimate;
    Data json = {
        {"mean", e.mean},       {"standard_error", e.standard_error}, {"independent_samples", e.independent_samples},
        {"samples", e.samples}, {"error_is_converged", e.converged},  {"unit", average.unit}};
    if (const auto si = si_unit(average.unit, units)) {
        json["si"] = {
            {"mean", e.mean * si->factor}, {"standard_error", e.standard_error * si->factor}, {"unit", si->name}};
    }
    return json;
}

Data observable_data(const ObservableAverage& average, const std::optional<SubstanceUnits>& units) {
    Data json = estimate_data(average, units);
    if (const std::string remark = remark_of(average); !remark.empty()) {
        json["remark"] = remark;
    }
    if (average.own) {
        json["own"] = true;
    }
    return json;
}

bool has_value(const ObservableAverage& average) {
    return average.estimate && std::isfinite(average.estimate->mean);
}

std::string shown_symbol(const ObservableAverage& average) {
    return average.own ? "own" : average.symbol;
}

/// One line of the table: name, symbol, value, mark, unit, samples.
std::vector<std::string> table_line(const ObservableAverage& average, Footnotes& footnotes) {
    const std::string mark = footnotes.mark(remark_of(average));
    if (!has_value(average)) {
        return {average.name, shown_symbol(average), "no value", mark};
    }
    const Estimate& e = *average.estimate;
    return {average.name,
            shown_symbol(average),
            with_error(e.mean, e.standard_error),
            mark,
            average.unit,
            std::isfinite(e.independent_samples) ? fmt::format("{:.0f}", e.independent_samples) : "-"};
}

TextTable empty_table(const std::string& heading, const std::string& samples) {
    using Align = TextTable::Align;
    // The widths are usual ones, so that the columns of tables below each other stand below each other, too.
    return TextTable({{heading, Align::left, 22},
                      {"", Align::left, 3},
                      {"mean +- error", Align::right, 21},
                      {"", Align::left, 0, 1},
                      {"unit", Align::left},
                      {samples}},
                     2);
}

/// The observables that have a unit of the substance; empty if there is none.
std::string si_table(const std::vector<ObservableAverage>& averages, const std::optional<SubstanceUnits>& units,
                     Footnotes& footnotes) {
    TextTable table = empty_table("in SI units", "");
    bool any = false;
    for (const ObservableAverage& average : averages) {
        const auto si = si_unit(average.unit, units);
        if (is_in_table(average) && has_value(average) && si) {
            const Estimate& e = *average.estimate;
            table.add({average.name, shown_symbol(average),
                       with_error(e.mean * si->factor, e.standard_error * si->factor),
                       footnotes.mark(remark_of(average)), si->name});
            any = true;
        }
    }
    return any ? table.text_within(screen_columns) : "";
}

Data at_requested_data(const std::optional<AtRequestedTemperature>& there, const std::optional<SubstanceUnits>& units) {
    if (!there) {
        return nullptr;
    }
    return {{"temperature", there->temperature},
            {"equation_of_state", there->equation},
            {"observables", observables_data(there->observables, units)}};
}

/// Lines below the table: results at the requested temperature.
std::string at_requested_lines(const std::optional<AtRequestedTemperature>& there,
                               const std::optional<SubstanceUnits>& units) {
    if (!there) {
        return "";
    }
    return fmt::format("\n  brought to T = {:.6g}, which was asked, by the equation of state {}:\n", there->temperature,
                       there->equation) +
           observables_table(there->observables, units);
}

}  // namespace

Data observables_data(const std::vector<ObservableAverage>& averages, const std::optional<SubstanceUnits>& units) {
    Data observables = Data::object();
    for (const ObservableAverage& average : averages) {
        observables[average.name] = observable_data(average, units);
    }
    return observables;
}

std::string observables_table(const std::vector<ObservableAverage>& averages,
                              const std::optional<SubstanceUnits>& units) {
    Footnotes footnotes;
    TextTable table = empty_table("observable", "n*");
    for (const ObservableAverage& average : averages) {
        if (is_in_table(average)) {
            table.add(table_line(average, footnotes));
        }
    }
    const bool own = std::ranges::any_of(averages, &ObservableAverage::own);
    const std::string si = si_table(averages, units, footnotes);
    return table.text_within(screen_columns) + (si.empty() ? "" : "\n" + si) + footnotes.text() +
           (own ? "  own: measured by the program that made the run\n" : "");
}

std::string samples_footnote() {
    return "  * independent samples: variance of the series over the squared error\n";
}

Document results_report(const RunPlan& plan, const RunResult& result) {
    Data system = {{"atoms", result.atoms},
                   {"density", result.density},
                   {"box_edges", Data::list({result.edges[0], result.edges[1], result.edges[2]})}};
    std::string line = fmt::format("{} atoms, density {:.6g} sigma^-3", result.atoms, result.density);
    if (plan.units()) {
        const double density = result.density * plan.units()->gram_per_cm3();
        system["density_g_per_cm3"] = density;
        line += fmt::format(" ({:.4f} g/cm3)", density);
    }
    const std::string box =
        fmt::format("box {:.6g} x {:.6g} x {:.6g} sigma^3", result.edges[0], result.edges[1], result.edges[2]);
    const bool fits = line.size() + box.size() + 2 <= screen_columns;
    std::string text = fmt::format("{}\n{},{}{}\n\n", title_line(plan), line, fits ? ' ' : '\n', box);
    text += observables_table(result.averages, plan.units());
    text += at_requested_lines(result.at_requested, plan.units());
    text += stage_lines(result.stages, "epsilon per atom and tau");
    text += samples_footnote();
    for (const std::string& doubt : result.doubts) {
        text += wrapped("  warning: " + doubt, screen_columns, 4) + '\n';
    }
    text += fmt::format("\nfiles: {}\n", plan.directory.string());
    Data stages = Data::list();
    for (const StageResult& stage : result.stages) {
        stages.push_back(stage_data(stage));
    }
    return {{{"title", plan.title},
             {"system", system},
             {"observables", observables_data(result.averages, plan.units())},
             {"asked_temperature", result.requested_temperature},
             {"at_asked_temperature", at_requested_data(result.at_requested, plan.units())},
             {"equation_of_state", result.equation_of_state},
             {"translational_order_at_sampling", result.order_at_sampling},
             {"stages", stages},
             {"neighbor_list_rebuilds", result.search.rebuilds},
             {"neighbor_list_late_rebuilds", result.search.late_rebuilds},
             {"doubts", result.doubts},
             {"warnings", result.warnings}},
            text};
}

DataTable with_si_columns(DataTable table, const std::optional<SubstanceUnits>& units) {
    if (!units) {
        return table;
    }
    struct SiColumn {
        std::string_view column;
        std::string_view suffix;
        double factor;
    };
    const std::array<SiColumn, 4> known{{{"r", "_nm", units->nanometre()},
                                         {"time", "_ps", units->picosecond()},
                                         {"k", "_per_nm", 1.0 / units->nanometre()},
                                         {"msd", "_nm2", units->nanometre() * units->nanometre()}}};
    const std::vector<std::string> reduced = table.columns;
    for (const SiColumn& si : known) {
        const auto found = std::ranges::find(reduced, si.column);
        if (found == reduced.end()) {
            continue;
        }
        const auto column = static_cast<std::size_t>(found - reduced.begin());
        table.columns.push_back(fmt::format("{}{}", si.column, si.suffix));
        for (auto& row : table.rows) {
            row.push_back(row[column] * si.factor);
        }
    }
    return table;
}

}  // namespace ljmd
