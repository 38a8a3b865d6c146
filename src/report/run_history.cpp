#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "deck/sampled_steps.hpp"
#include "io/tables/data_table_csv.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "report/quantity_names.hpp"
#include "report/run_charts.hpp"

namespace ljmd {

namespace {

constexpr std::size_t most_rows = 2000;
constexpr std::size_t blocks = 20;
constexpr std::array<const char*, 3> judged{"temperature", "potential_energy", "pressure"};

/// The rows of the sampled stages; all if the deck cannot be read.
DataTable sampled_rows(DataTable table, const RunFacts& facts, const std::filesystem::path& path) {
    if (const Deck* deck = facts.deck()) {
        const SampledSteps sampled(deck->stages());
        const std::vector<Index> steps = step_column(table, path);
        std::size_t row = 0;
        std::erase_if(table.rows, [&](const auto&) { return !sampled.contain(steps[row++]); });
    }
    return table;
}

/// Means of equally long blocks of the rows, with the time at the middle of each.
PageTable block_means(const DataTable& sampled) {
    PageTable table{.name = "blocks", .title = "Block averages of the sampled rows"};
    const std::size_t length = std::max<std::size_t>(1, sampled.rows.size() / blocks);
    const std::size_t count = sampled.rows.size() / length;
    const auto means = [&](const std::string& name) {
        const std::vector<double> values = column(sampled, name);
        std::vector<double> found;
        for (std::size_t k = 0; k < count; ++k) {
            double sum = 0.0;
            for (std::size_t i = k * length; i < (k + 1) * length; ++i) {
                sum += values[i];
            }
            found.push_back(sum / static_cast<double>(length));
        }
        return found;
    };
    table.add(described("time"), means("time"));
    for (const char* name : {"temperature", "potential_energy", "pressure", "density", "edge_x", "edge_y", "edge_z"}) {
        if (has_column(sampled, name)) {
            table.add(described(name), means(name));
        }
    }
    return table;
}

/// The change of the conserved energy since the first sampled row.
PageTable energy_change(const DataTable& sampled, const std::string& conserved) {
    const std::vector<double> energies = column(sampled, conserved);
    std::vector<double> changes;
    changes.reserve(energies.size());
    for (const double energy : energies) {
        changes.push_back(energy - energies.front());
    }
    DataTable table{"energy", {"time", "energy_change"}, {}};
    const std::vector<double> times = column(sampled, "time");
    for (std::size_t k = 0; k < times.size(); ++k) {
        table.rows.push_back({times[k], changes[k]});
    }
    return page_table(table, "Change of the conserved energy", "", {}, most_rows);
}

/// A line at the beginning of each stage but the first.
std::vector<Mark> stage_rules(const RunFacts& facts) {
    std::vector<Mark> marks;
    if (const Deck* deck = facts.deck()) {
        double time = 0.0;
        for (std::size_t k = 0; k + 1 < deck->stages().size(); ++k) {
            time += static_cast<double>(deck->stages()[k].steps) * deck->stages()[k].time_step;
            marks.push_back({.type = "rule-x", .label = deck->stages()[k + 1].name, .value = time, .colour = 7});
        }
    }
    return marks;
}

}  // namespace

bool has_column(const DataTable& table, const std::string& name) {
    return std::ranges::find(table.columns, name) != table.columns.end();
}

DataTable thinned(const DataTable& table, std::size_t most) {
    const std::size_t every = (table.rows.size() + most - 1) / std::max<std::size_t>(1, most);
    if (every <= 1) {
        return table;
    }
    DataTable shown{table.name, table.columns, {}};
    for (std::size_t k = 0; k < table.rows.size(); k += every) {
        shown.rows.push_back(table.rows[k]);
    }
    return shown;
}

PageTable page_table(const DataTable& table, const std::string& title, const std::string& file,
                     const std::vector<std::string>& columns, std::size_t most) {
    const DataTable shown = thinned(table, most);
    PageTable page{.name = table.name, .title = title, .file = file, .rows = static_cast<Index>(table.rows.size())};
    for (const std::string& name : columns.empty() ? table.columns : columns) {
        if (has_column(table, name)) {
            page.add(described(name), column(shown, name));
        }
    }
    return page;
}

void add_history(PageContent& page, const RunFacts& facts) {
    const std::filesystem::path path = facts.directory / "thermo.csv";
    const DataTable table = read_growing_csv(path);
    if (table.rows.empty()) {
        return;
    }
    const std::string conserved = has_column(table, "conserved_energy") ? "conserved_energy" : "total_energy";
    page.tables.push_back(
        page_table(table, "Time series", "thermo.csv",
                   {"step", "time", "temperature", "potential_energy", "kinetic_energy", "total_energy",
                    "conserved_energy", "pressure", "density", "edge_x", "edge_y", "edge_z", "order_parameter"},
                   most_rows));
    const DataTable sampled = sampled_rows(table, facts, path);
    const bool has_blocks = sampled.rows.size() > 1;
    if (has_blocks) {
        page.tables.push_back(block_means(sampled));
    }
    for (const char* name :
         {"temperature", "potential_energy", "pressure", "density", "edge_x", "edge_y", "edge_z", "order_parameter"}) {
        if (!has_column(table, name)) {
            continue;
        }
        Chart chart{.id = name,
                    .title = as_title(name),
                    .caption = "",
                    .lead = std::ranges::find(judged, std::string(name)) != judged.end(),
                    .x = {axis_label("time")},
                    .y = {axis_label(name)}};
        chart.follows_time = true;
        chart.marks = stage_rules(facts);
        chart.marks.push_back(
            {.type = "line", .label = in_plain_words(name), .table = "thermo", .x = "time", .y = name, .colour = 0});
        if (has_blocks && std::string_view(name) != "order_parameter") {
            chart.caption = "Points are averages over blocks of the sampled rows.";
            chart.marks.push_back(
                {.type = "dots", .label = "block average", .table = "blocks", .x = "time", .y = name, .colour = 1});
        }
        page.charts.push_back(std::move(chart));
    }
    if (has_blocks && has_column(sampled, conserved)) {
        page.tables.push_back(energy_change(sampled, conserved));
        page.charts.push_back(
            {.id = "energy",
             .title = "Conservation of energy",
             .caption =
                 conserved == "total_energy"
                     ? "Change of the total energy per atom since sampling began."
                     : "Change of the total energy per atom less the heat of the thermostat, since sampling began.",
             .lead = true,
             .x = {axis_label("time")},
             .y = {axis_label("energy_change")},
             .marks = {{.type = "rule-y", .label = "no change", .value = 0.0, .colour = 7},
                       {.type = "line",
                        .label = "change of the energy",
                        .table = "energy",
                        .x = "time",
                        .y = "energy_change",
                        .colour = 0}},
             .follows_time = true});
    }
}

void add_blocking_curves(PageContent& page, const RunFacts& facts) {
    const std::filesystem::path path = facts.directory / "thermo.csv";
    const DataTable sampled = sampled_rows(read_growing_csv(path), facts, path);
    constexpr std::size_t fewest_rows = 64;  // with fewer, there is hardly a curve
    if (sampled.rows.size() < fewest_rows) {
        return;
    }
    std::vector<double> lengths;
    std::vector<double> errors;
    std::vector<double> uncertainties;
    std::vector<std::string> names;
    for (const char* name : judged) {
        BlockingAccumulator accumulator(1, Covariance::diagonal);
        for (const double value : column(sampled, name)) {
            accumulator.add(Eigen::VectorXd::Constant(1, value));
        }
        const std::vector<BlockLevel> levels = accumulator.levels(0);
        if (levels.empty() || !(levels.front().standard_error > 0.0)) {
            continue;
        }
        for (const BlockLevel& level : levels) {
            const double ratio = level.standard_error / levels.front().standard_error;
            lengths.push_back(static_cast<double>(level.length));
            errors.push_back(ratio);
            uncertainties.push_back(ratio * level.relative_uncertainty);
            names.push_back(in_plain_words(name));
        }
    }
    if (lengths.empty()) {
        return;
    }
    PageTable table{.name = "blocking", .title = "Blocking curves"};
    table.add({"observable"}, names);
    table.add(described("length"), lengths);
    table.add({"error_ratio", "error / error without correlations"}, errors);
    table.add({"error_ratio_standard_error", "its uncertainty"}, uncertainties);
    page.tables.push_back(std::move(table));
    page.charts.push_back({.id = "blocking",
                           .title = "Blocking curves",
                           .caption =
                               "Error of the mean if blocks of this length are independent, in units of the error "
                               "without correlations. It is right where the curve is level.",
                           .x = {axis_label("length"), "log"},
                           .y = {"error / error without correlations"},
                           .marks = {{.type = "line",
                                      .label = "",
                                      .table = "blocking",
                                      .x = "length",
                                      .y = "error_ratio",
                                      .error = "error_ratio_standard_error",
                                      .group = "observable"}}});
}

}  // namespace ljmd
