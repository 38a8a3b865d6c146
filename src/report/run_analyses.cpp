#include <fmt/format.h>

#include <algorithm>

#include "io/files/input_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "report/lenient_data.hpp"
#include "report/quantity_names.hpp"
#include "report/run_charts.hpp"

namespace ljmd {

namespace {

/// The table's file, as a path within the directory; empty if there is none.
std::string file_of(const RunFacts& facts, const std::string& name) {
    for (const std::string& file : {name + ".csv", "analysis/" + name + ".csv"}) {
        if (input_is_there(facts.directory / file)) {
            return file;
        }
    }
    return "";
}

/// Whether the times of a table are ever further apart, as those of long times are.
bool goes_to_long_times(const PageTable& table, const std::string& column) {
    const auto found = std::ranges::find(table.columns, column, &PageColumn::name);
    if (column != "time" || found == table.columns.end()) {
        return false;
    }
    const Data::List& times = table.values[static_cast<std::size_t>(found - table.columns.begin())];
    double spacing = 0.0;
    for (std::size_t i = 1; i < times.size(); ++i) {
        if (!times[i - 1].is_number() || !times[i].is_number()) {
            return false;
        }
        const double step = times[i].number() - times[i - 1].number();
        if (step > 0.0 && spacing > 0.0 && step > 1.5 * spacing) {
            return true;
        }
        spacing = spacing == 0.0 ? step : spacing;
    }
    return false;
}

Chart chart_of(const AnalysisChart& drawn, const PageTable& table) {
    const std::string error = fmt::format("{}_standard_error", drawn.y);
    const bool has_error = table.has_column(error);
    const std::string caption = drawn.caption;
    const char* said_of_error = drawn.as_dots ? "Error bars are one standard error on either side."
                                              : "The band is one standard error on either side.";
    const bool is_long = goes_to_long_times(table, drawn.x);
    const bool is_logarithmic = drawn.logarithmic || (is_long && drawn.is_power_of_time);
    Chart chart{.id = fmt::format("{}-{}", drawn.file, drawn.y),
                .title = drawn.title,
                .caption = caption.empty() && has_error ? said_of_error : caption,
                .lead = drawn.lead,
                .x = {axis_label(drawn.x), is_long ? "log" : "linear"},
                .y = {axis_label(drawn.y), is_logarithmic ? "log" : "linear"}};
    if (drawn.level) {
        chart.marks.push_back({.type = "rule-y", .label = drawn.level_label, .value = drawn.level, .colour = 7});
    }
    const std::string expected = drawn.expected;
    if (!expected.empty()) {
        chart.marks.push_back({.type = "line",
                               .label = drawn.expected_label,
                               .table = table.name,
                               .x = drawn.x,
                               .y = expected,
                               .colour = 1});
    }
    if (!expected.empty() || drawn.as_dots) {
        chart.marks.push_back({.type = "dots",
                               .label = "measured",
                               .table = table.name,
                               .x = drawn.x,
                               .y = drawn.y,
                               .error = has_error ? error : ""});
        return chart;
    }
    if (has_error) {
        chart.marks.push_back({.type = "band",
                               .label = "standard error",
                               .table = table.name,
                               .x = drawn.x,
                               .y = drawn.y,
                               .error = error,
                               .group = drawn.group});
    }
    chart.marks.push_back(
        {.type = "line", .label = "measured", .table = table.name, .x = drawn.x, .y = drawn.y, .group = drawn.group});
    return chart;
}

bool has_values(const PageTable& table, const std::string& column) {
    const auto found = std::ranges::find(table.columns, column, &PageColumn::name);
    const Data::List& values = table.values[static_cast<std::size_t>(found - table.columns.begin())];
    return std::ranges::any_of(values, &Data::is_number);
}

/// Add a chart, and its table unless another chart has added it. @param file  of the table, within the directory
void add_chart(PageContent& page, const RunFacts& facts, const AnalysisChart& drawn, const std::string& file) {
    auto found = std::ranges::find(page.tables, std::string(drawn.file), &PageTable::name);
    if (found == page.tables.end()) {
        page.tables.push_back(page_table(read_csv(facts.directory / file), drawn.title, file));
        found = page.tables.end() - 1;
    }
    const auto has = [&](const std::string& column) { return column.empty() || found->has_column(column); };
    if (has(drawn.x) && has(drawn.y) && has(drawn.expected) && has_values(*found, drawn.y)) {
        page.charts.push_back(chart_of(drawn, *found));
    }
}

}  // namespace

void add_analyses(PageContent& page, const RunFacts& facts) {
    for (const AnalysisMethod& method : all_analyses()) {
        for (const AnalysisChart& drawn : method.charts) {
            if (const std::string file = file_of(facts, drawn.file); !file.empty()) {
                add_if_readable(page.warnings, [&] { add_chart(page, facts, drawn, file); });
            }
        }
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
