#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ljmd/io/files/input_file.hpp"
#include "ljmd/io/tables/data_table_csv.hpp"
#include "ljmd/report/lenient_data.hpp"
#include "ljmd/report/quantity_names.hpp"
#include "ljmd/report/run_charts.hpp"

namespace ljmd {

namespace {

/// A table of an analysis and how it is drawn.
struct AnalysisChart {
    const char* file;
    const char* x;
    const char* y;
    const char* title;
    bool lead = false;
    std::optional<double> rule = {};  ///< a level to compare with
    const char* rule_label = "";
    bool logarithmic = false;
};

const std::array<AnalysisChart, 10>& charts() {
    static const std::array<AnalysisChart, 10> all{
        {{"rdf", "r", "g", "Radial distribution function", true, 1.0, "no order"},
         {"sk", "k", "S", "Structure factor"},
         {"sk_from_rdf", "k", "S", "Structure factor from g(r)"},
         {"msd", "time", "msd", "Mean-square displacement"},
         {"vacf", "time", "vacf", "Velocity autocorrelation", false, 0.0, "no correlation"},
         {"vacf", "time", "diffusion", "Diffusion up to this time"},
         {"vibrational_spectrum", "angular_frequency", "spectrum", "Vibrational spectrum"},
         {"stress_autocorrelation", "time", "viscosity", "Viscosity up to this time"},
         {"pressure_autocorrelation", "time", "bulk_viscosity", "Bulk viscosity up to this time"},
         {"heat_flux_autocorrelation", "time", "thermal_conductivity", "Thermal conductivity up to this time"}}};
    return all;
}

/// The table's file, as a path within the directory; empty if there is none.
std::string file_of(const RunFacts& facts, const std::string& name) {
    for (const std::string& file : {name + ".csv", "analysis/" + name + ".csv"}) {
        if (input_is_there(facts.directory / file)) {
            return file;
        }
    }
    return "";
}

Chart chart_of(const AnalysisChart& drawn, const PageTable& table) {
    const std::string error = fmt::format("{}_standard_error", drawn.y);
    const bool has_error = table.has_column(error);
    Chart chart{.id = fmt::format("{}-{}", drawn.file, drawn.y),
                .title = drawn.title,
                .caption = has_error ? "The band is one standard error on either side." : "",
                .lead = drawn.lead,
                .x = {axis_label(drawn.x)},
                .y = {axis_label(drawn.y)}};
    if (drawn.rule) {
        chart.marks.push_back({.type = "rule-y", .label = drawn.rule_label, .value = drawn.rule, .colour = 7});
    }
    if (has_error) {
        chart.marks.push_back({.type = "band",
                               .label = "standard error",
                               .table = table.name,
                               .x = drawn.x,
                               .y = drawn.y,
                               .error = error});
    }
    chart.marks.push_back({.type = "line", .label = "measured", .table = table.name, .x = drawn.x, .y = drawn.y});
    return chart;
}

/// Heights of Bragg peaks, and those that the displacements of the atoms let expect.
Chart bragg_chart(const PageTable& table) {
    const char* peaks = "debye_waller_factor";
    return {.id = "bragg",
            .title = "Bragg peaks",
            .caption =
                "Height S(k)/N of the peaks, 1 in a crystal at rest. The line is exp(-k^2 <u^2>/3) of the measured "
                "displacements; on this scale it is nearly straight in k^2.",
            .lead = true,
            .x = {axis_label("k")},
            .y = {"S(k)/N", "log"},
            .marks = {{.type = "line",
                       .label = "from displacements",
                       .table = table.name,
                       .x = "k",
                       .y = "debye_waller_gaussian",
                       .colour = 1},
                      {.type = "dots",
                       .label = "peaks",
                       .table = table.name,
                       .x = "k",
                       .y = peaks,
                       .error = "debye_waller_factor_standard_error"}}};
}

}  // namespace

void add_analyses(PageContent& page, const RunFacts& facts) {
    for (const AnalysisChart& drawn : charts()) {
        const std::string file = file_of(facts, drawn.file);
        if (file.empty()) {
            continue;
        }
        add_if_readable(page.warnings, [&] {
            auto found = std::ranges::find(page.tables, std::string(drawn.file), &PageTable::name);
            if (found == page.tables.end()) {
                page.tables.push_back(page_table(read_csv(facts.directory / file), drawn.title, file));
                found = page.tables.end() - 1;
            }
            if (found->has_column(drawn.x) && found->has_column(drawn.y)) {
                page.charts.push_back(chart_of(drawn, *found));
            }
        });
    }
    if (const std::string file = file_of(facts, "bragg"); !file.empty()) {
        add_if_readable(page.warnings, [&] {
            PageTable table = page_table(read_csv(facts.directory / file), "Bragg peaks", file);
            if (table.has_column("debye_waller_factor") && table.has_column("debye_waller_gaussian")) {
                page.charts.push_back(bragg_chart(table));
            }
            page.tables.push_back(std::move(table));
        });
    }
}

void add_phases(PageContent& page, const RunFacts& facts) {
    const Data* phases = value_in(facts.record, {"seconds_per_phase"});
    if (phases == nullptr || !phases->is_object()) {
        return;
    }
    std::vector<std::string> names;
    std::vector<double> seconds;
    for (const auto& [name, value] : phases->members()) {
        if (value.is_number()) {
            names.push_back(name);
            seconds.push_back(value.number());
        }
    }
    PageTable table{.name = "phases", .title = "Wall time by phase"};
    table.add({"phase"}, names);
    table.add(described("seconds"), seconds);
    page.tables.push_back(std::move(table));
    page.charts.push_back(
        {.id = "phases",
         .title = "Where the time went",
         .caption = "Wall time of the time loop by phase.",
         .x = {"phase", "category"},
         .y = {axis_label("seconds")},
         .marks = {{.type = "bars", .label = "seconds", .table = "phases", .x = "phase", .y = "seconds"}}});
}

}  // namespace ljmd
