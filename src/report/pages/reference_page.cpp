#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/input_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "report/lenient_data.hpp"
#include "report/pages/study_pages.hpp"
#include "report/quantity_names.hpp"
#include "report/run_charts.hpp"
#include "study/study_report.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

constexpr double far = 3.0;  // errors from an equation of state

/// A property with both errors together; the statistical one where the other is not assessed.
Quantity reference_quantity(const std::string& name, const Data& entry) {
    const auto total = number_in(entry, {"total_error"});
    Quantity quantity{.name = name,
                      .symbol = symbol_of(name),
                      .value = number_in(entry, {"mean"}).value_or(std::nan("")),
                      .error = total ? total : number_in(entry, {"statistical_error"}),
                      .unit = text_in(entry, {"unit"}),
                      .samples = number_in(entry, {"independent_samples"}),
                      .remark = text_in(entry, {"remark"}),
                      .reference = number_in(entry, {"equation_of_state"}),
                      .reference_label = "thol2016"};
    if (quantity.unit == "1") {
        quantity.unit.clear();
    }
    return quantity;
}

/// How far a value is from the equations of state, whose difference counts as the error of both.
std::optional<double> errors_apart(const Data& entry) {
    const auto mean = number_in(entry, {"mean"});
    const auto error = number_in(entry, {"total_error"});
    const auto thol = number_in(entry, {"equations_of_state", "thol2016"});
    const auto other = number_in(entry, {"equations_of_state", "kolafa-nezbeda1994"});
    if (!mean || !error || !thol || !other) {
        return std::nullopt;
    }
    return (*mean - *thol) / std::hypot(*error, *thol - *other);
}

PageTable errors_table(const std::vector<std::pair<std::string, const Data*>>& values) {
    PageTable table{.name = "values", .title = "Values and what they are uncertain by", .lead = true};
    std::vector<std::string> names;
    std::vector<std::string> units;
    names.reserve(values.size());
    units.reserve(values.size());
    for (const auto& [name, entry] : values) {
        names.push_back(name);
        units.push_back(text_in(*entry, {"unit"}));
    }
    table.add({"property"}, names);
    const auto numbers = [&](const char* column, const char* label) {
        std::vector<double> found;
        found.reserve(values.size());
        for (const auto& value : values) {
            found.push_back(number_in(*value.second, {column}).value_or(std::nan("")));
        }
        table.add({column, label}, found);
    };
    numbers("mean", "value");
    numbers("statistical_error", "statistical error");
    numbers("systematic_error", "systematic error");
    numbers("cutoff_correction", "corrected for the cutoff");
    numbers("size_correction", "corrected for the size");
    numbers("equation_of_state", "thol2016");
    std::vector<double> apart;
    apart.reserve(values.size());
    for (const auto& value : values) {
        apart.push_back(errors_apart(*value.second).value_or(std::nan("")));
    }
    table.add({"apart", "errors apart"}, apart);
    table.add({"unit"}, units);
    return table;
}

Verdict agreement(const std::vector<std::pair<std::string, const Data*>>& values) {
    std::size_t compared = 0;
    std::string far_ones;
    for (const auto& [name, entry] : values) {
        const auto apart = errors_apart(*entry);
        compared += apart ? 1U : 0U;
        if (apart && std::abs(*apart) > far) {
            far_ones += fmt::format("{}{} ({:.1f} errors)", far_ones.empty() ? "" : ", ", name, *apart);
        }
    }
    return {
        "agreement", far_ones.empty() ? "good" : "doubt",
        far_ones.empty()
            ? fmt::format("All {} values that an equation of state has agree with it within three errors.", compared)
            : fmt::format("Farther than three errors from the equations of state: {}.", far_ones)};
}

/// Distances from the equation of state in errors of both, and what each error has of the whole: pictures of the table.
void add_value_charts(PageContent& page, const std::vector<std::pair<std::string, const Data*>>& values) {
    std::vector<std::string> compared;
    std::vector<double> apart;
    Data::List is_far;
    std::vector<std::string> names;
    std::vector<std::string> sources;
    std::vector<double> parts;
    for (const auto& [name, entry] : values) {
        if (const auto distance = errors_apart(*entry)) {
            compared.push_back(in_plain_words(name));
            apart.push_back(*distance);
            is_far.emplace_back(std::abs(*distance) > far);
        }
        const auto mean = number_in(*entry, {"mean"});
        for (const auto& [key, source] :
             {std::pair("statistical_error", "statistical"), std::pair("systematic_error", "systematic")}) {
            const auto error = number_in(*entry, {key});
            if (mean && *mean != 0.0 && error) {
                names.push_back(in_plain_words(name));
                sources.emplace_back(source);
                parts.push_back(100.0 * *error / std::abs(*mean));
            }
        }
    }
    if (!compared.empty()) {
        PageTable table{.name = "apart", .title = "Distance from the equation of state", .flag = "far"};
        table.add({"property"}, compared);
        table.add({"apart", "errors apart"}, apart);
        table.add({"far"}, std::move(is_far));
        page.tables.push_back(std::move(table));
        page.charts.push_back(
            {.id = "apart",
             .title = "Beside the equation of state",
             .caption = "Value less that of thol2016, in units of the error of both: the total error, and the "
                        "difference between two equations of state.",
             .lead = true,
             .x = {"errors apart"},
             .y = {"property", "category"},
             .marks = {{.type = "diverging-dots",
                        .label = "value less equation of state",
                        .table = "apart",
                        .x = "apart",
                        .y = "property",
                        .flag = "far"}}});
    }
    if (!parts.empty()) {
        PageTable table{.name = "errors", .title = "Errors as parts of the values"};
        table.add({"property"}, names);
        table.add({"source"}, sources);
        table.add({"part", "error", "%"}, parts);
        page.tables.push_back(std::move(table));
        page.charts.push_back(
            {.id = "errors",
             .title = "What the values are uncertain by",
             .caption = "Statistical errors shrink with longer runs, systematic ones do not. One that is not "
                        "assessed is not drawn.",
             .lead = true,
             .x = {"error / %", "log"},
             .y = {"property", "category"},
             .marks = {{.type = "dots",
                        .label = "error",
                        .table = "errors",
                        .x = "part",
                        .y = "property",
                        .group = "source"}}});
    }
}

void add_provenance(PageContent& page, const Data& results) {
    const auto add = [&](const char* words, DataPath path) {
        if (const auto number = number_in(results, path)) {
            page.provenance.emplace_back(words, fmt::format("{:.6g}", *number));
        }
    };
    add("temperature", {"temperature"});
    add("density of the runs", {"density_of_runs"});
    add("pressure that was asked for", {"asked_pressure"});
    add("density of the saturated vapour", {"phase_diagram", "saturated_vapour"});
    add("density of the saturated liquid", {"phase_diagram", "saturated_liquid"});
    add("density at freezing", {"phase_diagram", "freezing"});
    add("density at melting", {"phase_diagram", "melting"});
    add("atoms", {"runs", "atoms"});
    add("replicas", {"runs", "replicas"});
    add("seed", {"runs", "seed"});
    add("cutoff", {"runs", "cutoff"});
    add("pairs counted up to", {"runs", "counted_radius"});
    add("steps of equilibration", {"runs", "equilibration_steps"});
    add("steps of each canonical run", {"runs", "canonical", "steps"});
    add("time step of canonical runs", {"runs", "canonical", "time_step"});
    add("steps of each run at constant energy", {"runs", "transport", "steps"});
    add("time step of runs at constant energy", {"runs", "transport", "time_step"});
}

}  // namespace

PageContent reference_page(const fs::path& directory) {
    PageContent page{.kind = "reference", .title = "Reference values", .source = directory.string()};
    const Data study = study_report(directory).data;
    add_study_state(page, study);
    page.points = study_points(study["runs"], directory);
    if (!input_is_there(directory / "results.json")) {
        return page;
    }
    add_if_readable(page.warnings, [&] {
        const Data results = read_any_json(directory / "results.json");
        page.title =
            fmt::format("Lennard-Jones fluid at T = {:.6g}, rho = {:.6g}: {}",
                        number_in(results, {"temperature"}).value_or(std::nan("")),
                        number_in(results, {"density_of_runs"}).value_or(std::nan("")), text_in(results, {"phase"}));
        std::vector<std::pair<std::string, const Data*>> values;
        for (const auto& [name, entry] : results.members()) {
            if (entry.is_object() && entry.contains("statistical_error")) {
                values.emplace_back(name, &entry);
                page.quantities.push_back(reference_quantity(name, entry));
            }
        }
        page.verdicts.push_back(agreement(values));
        page.tables.push_back(errors_table(values));
        add_value_charts(page, values);
        add_provenance(page, results);
        for (const Data& warning : results.at("warnings").items()) {
            page.warnings.push_back(warning.text());
        }
        page.downloads.emplace_back("methods", results.at("citation").text());
    });
    if (input_is_there(directory / "rdf.csv")) {
        add_if_readable(page.warnings, [&] {
            page.tables.push_back(
                page_table(read_csv(directory / "rdf.csv"), "Radial distribution function", "rdf.csv"));
            page.charts.push_back({.id = "rdf",
                                   .title = "Radial distribution function",
                                   .caption = "g(r) of all replicas together.",
                                   .lead = true,
                                   .x = {axis_label("r")},
                                   .y = {axis_label("g")},
                                   .marks = {{.type = "rule-y", .label = "", .value = 1.0, .colour = 7},
                                             {.type = "line", .label = "g(r)", .table = "rdf", .x = "r", .y = "g"}}});
        });
    }
    return page;
}

}  // namespace ljmd
