#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/input_file.hpp"
#include "ljmd/core/errors.hpp"
#include "report/lenient_data.hpp"
#include "report/pages/study_pages.hpp"
#include "report/quantity_names.hpp"
#include "report/run_quantities.hpp"
#include "study/study_report.hpp"
#include "study/sweep_record.hpp"

namespace ljmd {

namespace {

constexpr std::size_t leading_charts = 2;

/// The finished replicas: their names, and the quantities of each.
struct FinishedReplicas {
    std::vector<std::string> names;
    std::vector<std::vector<Quantity>> quantities;

    /// The quantity of this name of each; null pointers where there is none.
    [[nodiscard]] std::vector<const Quantity*> all(const std::string& name) const {
        std::vector<const Quantity*> found;
        found.reserve(quantities.size());
        for (const auto& each : quantities) {
            const auto at = std::ranges::find(each, name, &Quantity::name);
            found.push_back(at == each.end() ? nullptr : &*at);
        }
        return found;
    }
};

FinishedReplicas finished_replicas(const std::vector<ChildRun>& runs, PageContent& page) {
    FinishedReplicas finished;
    for (const ChildRun& run : runs) {
        if (input_is_there(run.directory / "results.json")) {
            add_if_readable(page.warnings, [&] {
                finished.quantities.push_back(quantities_in(read_any_json(run.directory / "results.json")));
                finished.names.push_back(run.name);
            });
        }
    }
    return finished;
}

PageTable replicas_table(const FinishedReplicas& finished, const std::vector<std::string>& names) {
    PageTable table{.name = "replicas", .title = "Replicas", .lead = true};
    table.add({"replica"}, finished.names);
    for (const std::string& name : names) {
        std::vector<double> values;
        std::vector<double> errors;
        for (const Quantity* quantity : finished.all(name)) {
            values.push_back(quantity != nullptr ? quantity->value : std::nan(""));
            errors.push_back(quantity != nullptr ? quantity->error.value_or(std::nan("")) : std::nan(""));
        }
        table.add(described(name), values);
        table.add(described(name + "_standard_error"), errors);
    }
    return table;
}

/// Means of the replicas, and a line at the merged one.
Chart replicas_chart(const std::string& name, const std::vector<Quantity>& merged) {
    Chart chart{.id = name,
                .title = as_title(name),
                .caption = "Means of the replicas with their errors.",
                .x = {"replica", "category"},
                .y = {axis_label(name)}};
    chart.marks.push_back({.type = "dots",
                           .label = "replicas",
                           .table = "replicas",
                           .x = "replica",
                           .y = name,
                           .error = name + "_standard_error"});
    const auto whole = std::ranges::find(merged, name, &Quantity::name);
    if (whole != merged.end() && std::isfinite(whole->value)) {
        chart.marks.push_back({.type = "rule-y", .label = "merged", .value = whole->value, .colour = 2});
    }
    return chart;
}

}  // namespace

PageContent replicas_page(const std::filesystem::path& directory) {
    const auto plan = recorded_sweep(directory);
    if (!plan || plan->replicas == 0) {
        throw DataError(fmt::format("{} is not the directory of replicas", directory.string()));
    }
    PageContent page{.kind = "sweep",
                     .title = fmt::format("{} replicas of {}", plan->replicas, plan->deck_file),
                     .source = directory.string(),
                     .downloads = {{"deck", plan->deck}}};
    const Data study = study_report(directory).data;
    add_study_state(page, study);
    page.points = study_points(study["runs"], directory);
    if (input_is_there(directory / "results.json")) {
        add_if_readable(page.warnings, [&] {
            const Data results = read_any_json(directory / "results.json");
            page.quantities = quantities_in(results);
            for (const Data& warning : results.at("warnings").items()) {
                page.warnings.push_back(warning.text());
            }
        });
    }
    const FinishedReplicas finished = finished_replicas(sweep_runs(*plan, directory), page);
    if (finished.names.empty()) {
        return page;
    }
    std::vector<std::string> names;
    names.reserve(finished.quantities.front().size());
    for (const Quantity& quantity : finished.quantities.front()) {
        names.push_back(quantity.name);
    }
    page.tables.push_back(replicas_table(finished, names));
    for (const std::string& name : names) {
        page.charts.push_back(replicas_chart(name, page.quantities));
        page.charts.back().lead = page.charts.size() <= leading_charts;
    }
    return page;
}

}  // namespace ljmd
