#include "report/pages/few_body_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/files/input_file.hpp"
#include "io/formats/body_trajectory.hpp"
#include "io/tables/data_table_csv.hpp"
#include "report/body_tracks.hpp"
#include "report/lenient_data.hpp"
#include "report/quantity_names.hpp"
#include "report/run_charts.hpp"

namespace ljmd {

namespace {

constexpr std::size_t most_few_body_rows = 3000;

std::vector<double> masses_of(const RunFacts& facts) {
    std::vector<double> masses;
    if (const Deck* deck = facts.deck(); deck != nullptr && !deck->is_fluid()) {
        for (const auto& body : deck->few_body().bodies) {
            masses.push_back(body.mass);
        }
    }
    return masses;
}

/// Totals at the start and the end, from results.json.
void add_totals(PageContent& page, const Data& results) {
    const Data* observables = value_in(results, {"observables"});
    if (observables == nullptr || !observables->is_object()) {
        return;
    }
    std::vector<std::string> names;
    std::vector<double> starts;
    std::vector<double> ends;
    std::vector<double> deviations;
    const auto value = [](const Data& entry, const char* key) {
        return number_in(entry, {key}).value_or(std::nan(""));
    };
    for (const auto& [name, entry] : observables->members()) {
        names.push_back(in_plain_words(name));
        starts.push_back(value(entry, "at_start"));
        ends.push_back(value(entry, "at_end"));
        deviations.push_back(value(entry, "largest_deviation"));
    }
    PageTable table{.name = "totals", .title = "Totals", .file = "results.json"};
    table.add({"total"}, names);
    table.add({"at_start", "at the start"}, starts);
    table.add({"at_end", "at the end"}, ends);
    table.add({"largest_deviation", "largest deviation"}, deviations);
    page.tables.push_back(std::move(table));
}

/// What the analyses found: "orbit period".
void add_findings(PageContent& page, const Data& results) {
    const Data* analyses = value_in(results, {"analysis"});
    if (analyses == nullptr || !analyses->is_object()) {
        return;
    }
    for (const auto& [analysis, findings] : analyses->members()) {
        if (!findings.is_object()) {
            continue;
        }
        for (const auto& [name, entry] : findings.members()) {
            page.quantities.push_back({.name = fmt::format("{}_{}", analysis, name),
                                       .value = number_in(entry, {"value"}).value_or(std::nan("")),
                                       .error = number_in(entry, {"standard_error"}),
                                       .remark = text_in(entry, {"remark"})});
        }
    }
}

/// Whether the energy stayed what it was. The limits are those within which the picture of the motion is right.
Verdict energy_verdict(const DataTable& thermo) {
    constexpr double small = 1e-3;
    constexpr double large = 0.05;
    const std::vector<double> errors = energy_errors(thermo);
    double largest = 0.0;
    for (const double error : errors) {
        largest = std::max(largest, std::abs(error));
    }
    const double last = errors.empty() ? 0.0 : errors.back();
    return {"energy",
            largest <= small   ? "good"
            : largest <= large ? "doubt"
                               : "bad",
            fmt::format("{} by at most {:.1e} of its value; at the end it is off by {:+.1e}.",
                        largest <= small   ? "Energy is conserved: it changes"
                        : largest <= large ? "Energy is conserved roughly: it changes"
                                           : "Energy is not conserved: it changes",
                        largest, last)};
}

void add_thermo(PageContent& page, const DataTable& thermo) {
    DataTable errors{"energy", {"time", "energy_error"}, {}};
    const std::vector<double> times = column(thermo, "time");
    const std::vector<double> values = energy_errors(thermo);
    for (std::size_t k = 0; k < times.size(); ++k) {
        errors.rows.push_back({times[k], values[k]});
    }
    page.verdicts.push_back(energy_verdict(thermo));
    page.tables.push_back(page_table(errors, "Error of the energy", "", {}, most_few_body_rows));
    page.charts.push_back(
        {.id = "energy",
         .title = "Error of the energy",
         .caption = "(E - E(0))/|E(0)|.",
         .lead = true,
         .x = {"t"},
         .y = {"relative error of the energy"},
         .marks = {{.type = "rule-y", .label = "no error", .value = 0.0, .colour = 7},
                   {.type = "line", .label = "error", .table = "energy", .x = "time", .y = "energy_error"}},
         .follows_time = true});
    page.tables.push_back(page_table(thermo, "Totals against time", "thermo.csv", {}, most_few_body_rows));
    for (const std::string& name : thermo.columns) {
        if (name.starts_with("angular_momentum")) {
            page.charts.push_back(
                {.id = name,
                 .title = "Angular momentum",
                 .caption = "",
                 .x = {"t"},
                 .y = {in_plain_words(name)},
                 .marks = {{.type = "line", .label = in_plain_words(name), .table = "thermo", .x = "time", .y = name}},
                 .follows_time = true});
        }
    }
}

/// The paths of all bodies in one table, with the number of the body.
PageTable paths(const DataTable& trajectory, const TrackShape& shape) {
    const DataTable shown = thinned(trajectory, most_few_body_rows);
    std::vector<std::string> bodies;
    std::vector<double> x;
    std::vector<double> y;
    for (std::size_t body = 1; body <= shape.bodies; ++body) {
        const std::vector<double> of_x = column(shown, fmt::format("x{}", body));
        const std::vector<double> of_y = column(shown, fmt::format("y{}", body));
        x.insert(x.end(), of_x.begin(), of_x.end());
        y.insert(y.end(), of_y.begin(), of_y.end());
        bodies.insert(bodies.end(), of_x.size(), fmt::format("body {}", body));
    }
    PageTable table{.name = "paths", .title = "Paths"};
    table.add({"body"}, bodies);
    table.add({"x"}, x);
    table.add({"y"}, y);
    return table;
}

/// @param file  its name
void add_trajectory(PageContent& page, const DataTable& trajectory, const std::string& file) {
    const TrackShape shape = track_shape(trajectory);
    if (shape.dimensions >= 2) {
        page.tables.push_back(paths(trajectory, shape));
        page.charts.push_back(
            {.id = "orbit",
             .title = "Orbit",
             .caption = "Paths in the plane of x and y.",
             .lead = true,
             .x = {"x"},
             .y = {"y"},
             .marks = {{.type = "line", .label = "", .table = "paths", .x = "x", .y = "y", .group = "body"}},
             .equal_axes = true});
    }
    if (has_column(trajectory, "x1") && has_column(trajectory, "vx1")) {
        page.tables.push_back(
            page_table(trajectory, "Body 1 in phase space", file, {"time", "x1", "vx1"}, most_few_body_rows));
        page.charts.push_back(
            {.id = "phase",
             .title = "Phase portrait",
             .caption = "Velocity against position of body 1, along x.",
             .lead = shape.dimensions == 1,
             .x = {"x"},
             .y = {"dx/dt"},
             .marks = {{.type = "line", .label = "body 1", .table = "trajectory", .x = "x1", .y = "vx1"}}});
    }
}

/// Distances at the apsides against time.
void add_apsides(PageContent& page, const DataTable& orbit) {
    std::vector<std::string> kinds;
    for (const double is_apocentre : column(orbit, "apocentre")) {
        kinds.emplace_back(is_apocentre != 0.0 ? "apocentre" : "pericentre");
    }
    PageTable table{
        .name = "orbit", .title = "Apsides", .file = "orbit.csv", .rows = static_cast<Index>(orbit.rows.size())};
    table.add({"apsis"}, kinds);
    for (const char* name : {"time", "distance", "angle"}) {
        table.add({name}, column(orbit, name));
    }
    page.tables.push_back(std::move(table));
    if (orbit.rows.size() < 2) {
        return;  // a single dot is no chart
    }
    page.charts.push_back(
        {.id = "apsides",
         .title = "Distance at the apsides",
         .caption = "",
         .x = {"t"},
         .y = {"distance"},
         .marks = {{.type = "dots", .label = "", .table = "orbit", .x = "time", .y = "distance", .group = "apsis"}}});
}

}  // namespace

PageContent few_body_page(const RunFacts& facts) {
    PageContent page = page_of(facts);
    const auto with_table = [&](const std::string& name, const auto& read, const auto& use) {
        if (input_is_there(facts.directory / name)) {
            add_if_readable(page.warnings, [&] {
                const DataTable table = read(facts.directory / name);
                if (!table.rows.empty()) {
                    use(table);
                }
            });
        }
    };
    const auto with_file = [&](const char* name, const auto& use) { with_table(name, read_growing_csv, use); };
    add_findings(page, facts.results);
    with_file("thermo.csv", [&](const DataTable& thermo) {
        add_thermo(page, thermo);
        const auto show = [&](const std::string& name, const auto& read) {
            with_table(name, read, [&](const DataTable& trajectory) {
                page.tracks = body_tracks(trajectory, thermo, masses_of(facts));
                add_trajectory(page, trajectory, name);
            });
        };
        show("trajectory.csv", read_growing_csv);
        show("trajectory.xyz", read_body_trajectory);
        show("trajectory.h5md", read_body_trajectory);
    });
    add_totals(page, facts.results);
    with_file("orbit.csv", [&](const DataTable& orbit) { add_apsides(page, orbit); });
    return page;
}

}  // namespace ljmd
