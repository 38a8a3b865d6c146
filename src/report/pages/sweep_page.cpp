#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "core/text.hpp"
#include "io/files/input_file.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "report/equation_curve.hpp"
#include "report/lenient_data.hpp"
#include "report/pages/study_pages.hpp"
#include "report/quantity_names.hpp"
#include "report/run_quantities.hpp"
#include "run/recorded_results.hpp"
#include "run/recorded_run.hpp"
#include "study/study_report.hpp"
#include "study/sweep_points.hpp"
#include "study/sweep_record.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// The finished points of a sweep.
struct Finished {
    std::vector<std::vector<std::string>> values;  ///< of the keys
    std::vector<std::vector<Quantity>> quantities;
    std::vector<double> densities;  ///< of the box; NaN if not known
};

bool is_shown(const std::string& name) {
    return is_in_table({name, "", "", std::nullopt});
}

void add_point(Finished& finished, const fs::path& directory) {
    std::vector<Quantity> quantities;
    double density = std::nan("");
    for (const ObservedMean& found : read_results(directory / "results.json").means) {
        if (is_shown(found.name)) {
            quantities.push_back({.name = found.name, .value = found.mean, .error = found.standard_error});
        }
        density = found.name == "density" ? found.mean : density;
    }
    const RecordedRun run = recorded_run(directory);
    if (run.deck.is_fluid()) {
        const Data results = read_any_json(directory / "results.json");
        const auto of_box = number_in(results, {"system", "density"});
        static_cast<void>(add_references(quantities, run.deck, of_box, directory));
        density = std::isfinite(density) ? density : of_box.value_or(density);
    }
    finished.quantities.push_back(std::move(quantities));
    finished.densities.push_back(density);
}

/// All names in order of appearance.
std::vector<std::string> names_of(const Finished& finished) {
    std::vector<std::string> names;
    for (const auto& quantities : finished.quantities) {
        for (const Quantity& each : quantities) {
            if (std::ranges::find(names, each.name) == names.end()) {
                names.push_back(each.name);
            }
        }
    }
    return names;
}

/// A number of the quantity of this name at each point; NaN where there is none.
template <class Number>
std::vector<double> numbers(const Finished& finished, const std::string& name, const Number& number) {
    std::vector<double> found;
    for (const auto& quantities : finished.quantities) {
        const auto at = std::ranges::find(quantities, name, &Quantity::name);
        found.push_back(at == quantities.end() ? std::nan("") : number(*at).value_or(std::nan("")));
    }
    return found;
}

/// A varied key: its values as numbers where all are, and how many different ones there are.
struct VariedKey {
    std::string heading;
    std::vector<std::string> texts;
    std::vector<double> numbers;  ///< empty if one of the values is no number
    std::size_t different;
    bool is_temperature;
};

std::vector<VariedKey> keys_of(const SweepPlan& plan, const Finished& finished) {
    const std::vector<std::string> headings = short_keys(plan.points.keys);
    std::vector<VariedKey> keys;
    for (std::size_t k = 0; k < headings.size(); ++k) {
        VariedKey key{headings[k], {}, {}, 0, plan.points.keys[k].ends_with("temperature")};
        for (const auto& values : finished.values) {
            key.texts.push_back(values[k]);
            if (const auto number = to_number(values[k])) {
                key.numbers.push_back(*number);
            }
        }
        if (key.numbers.size() != key.texts.size()) {
            key.numbers.clear();
        }
        key.different = std::set<std::string>(key.texts.begin(), key.texts.end()).size();
        keys.push_back(std::move(key));
    }
    if (keys.size() > 1) {  // a seed of its own for each point is no axis
        std::erase_if(keys,
                      [](const VariedKey& key) { return key.heading == "seed" && key.different == key.texts.size(); });
    }
    return keys;
}

/// The name of a key's column; the measured temperature has the plain name.
std::string column_of(const VariedKey& key) {
    return "set_" + key.heading;
}

/// The values of all keys but one, "rho = 0.8, cutoff = 2.5": one series a text.
std::vector<std::string> series_of(const std::vector<VariedKey>& keys, std::size_t but) {
    std::vector<std::string> series(keys.front().texts.size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        for (std::size_t point = 0; k != but && point < series.size(); ++point) {
            series[point] +=
                fmt::format("{}{} = {}", series[point].empty() ? "" : ", ", keys[k].heading, keys[k].texts[point]);
        }
    }
    return series;
}

PageTable points_table(const Finished& finished, const std::vector<VariedKey>& keys, std::size_t along) {
    PageTable table{.name = "points", .title = "Points", .file = "sweep.csv", .lead = true};
    for (const VariedKey& key : keys) {
        if (key.numbers.empty()) {
            table.add({column_of(key), key.heading}, key.texts);
        } else {
            table.add({column_of(key), key.heading}, key.numbers);
        }
    }
    if (keys.size() > 1) {
        table.add({"series"}, series_of(keys, along));
    }
    for (const std::string& name : names_of(finished)) {
        table.add(described(name), numbers(finished, name, [](const Quantity& q) { return std::optional(q.value); }));
        table.add(described(name + "_standard_error"),
                  numbers(finished, name, [](const Quantity& q) { return q.error; }));
        const std::vector<double> references = numbers(finished, name, [](const Quantity& q) { return q.reference; });
        if (std::ranges::any_of(references, [](double value) { return std::isfinite(value); })) {
            PageColumn column = described(name);
            table.add({name + "_reference", column.label + " of the equation of state", column.unit}, references);
        }
    }
    return table;
}

std::string equation_of(const Finished& finished) {
    for (const auto& quantities : finished.quantities) {
        for (const Quantity& each : quantities) {
            if (!each.reference_label.empty()) {
                return each.reference_label;
            }
        }
    }
    return "";
}

/// What a sweep is about first; the energies that follow from others are in the table alone, and so is what has no
/// value.
std::vector<std::string> drawn_names(const Finished& finished) {
    std::vector<std::string> names{"potential_energy", "pressure"};
    for (const std::string& name : names_of(finished)) {
        const bool follows = name == "kinetic_energy" || name == "total_energy";
        if (std::ranges::find(names, name) == names.end() && !follows) {
            names.push_back(name);
        }
    }
    std::erase_if(names, [&](const std::string& name) {
        const auto values = numbers(finished, name, [](const Quantity& q) { return std::optional(q.value); });
        return std::ranges::none_of(values, [](double value) { return std::isfinite(value); });
    });
    return names;
}

/// The state of each point on the axis.
std::vector<StateOnAxis> states_of(const Finished& finished, const std::vector<double>& places,
                                   const std::vector<std::string>& series) {
    const auto temperatures =
        numbers(finished, "temperature", [](const Quantity& q) { return std::optional(q.value); });
    const auto errors = numbers(finished, "temperature", [](const Quantity& q) { return q.error; });
    std::vector<StateOnAxis> states;
    for (std::size_t point = 0; point < places.size(); ++point) {
        std::string equation;
        for (const Quantity& each : finished.quantities[point]) {
            equation = each.reference_label.empty() ? equation : each.reference_label;
        }
        states.push_back(
            {places[point], temperatures[point], errors[point], finished.densities[point], equation, series[point]});
    }
    return states;
}

Chart line_chart(const PageTable& table, const PageTable& curves, const std::string& name, const std::string& x,
                 const Axis& axis, const std::string& equation) {
    const std::string group = table.has_column("series") ? "series" : "";
    Chart chart{.id = name,
                .title = as_title(name),
                .caption = x == "temperature" ? "Against the temperature that was measured." : "",
                .x = axis,
                .y = {axis_label(name)}};
    if (const std::string reference = name + "_reference"; curves.has_column(reference)) {
        chart.caption += fmt::format("{}The curve is the equation of state {}, where one phase is stable.",
                                     chart.caption.empty() ? "" : " ", equation);
        chart.marks.push_back({.type = "line",
                               .label = equation,
                               .table = curves.name,
                               .x = x,
                               .y = reference,
                               .group = group,
                               .colour = 2});
    }
    chart.marks.push_back({.type = "dots",
                           .label = "measured",
                           .table = table.name,
                           .x = x,
                           .y = name,
                           .error = name + "_standard_error",
                           .group = group});
    return chart;
}

Chart map_chart(const std::string& name, const VariedKey& key, const VariedKey& other) {
    return {.id = name + "-map",
            .title = as_title(name) + ", as a map",
            .caption = "",
            .x = {key.heading, "category"},
            .y = {other.heading, "category"},
            .marks = {{.type = "cells",
                       .label = axis_label(name),
                       .table = "points",
                       .x = column_of(key),
                       .y = column_of(other),
                       .fill = name}}};
}

/// Order the points along the axis of the charts, because lines join them in their order.
void sort_points(Finished& finished, const std::vector<double>& along) {
    std::vector<std::size_t> order(along.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t point) { return along[point]; });
    Finished sorted;
    for (const std::size_t point : order) {
        sorted.values.push_back(finished.values[point]);
        sorted.quantities.push_back(finished.quantities[point]);
        sorted.densities.push_back(finished.densities[point]);
    }
    finished = std::move(sorted);
}

/// The key that varies most becomes the axis; for temperatures the measured ones.
void add_points(PageContent& page, const SweepPlan& plan, Finished finished) {
    std::vector<VariedKey> keys = keys_of(plan, finished);
    const auto different = [](const VariedKey& key) { return key.numbers.empty() ? std::size_t{0} : key.different; };
    const auto along = static_cast<std::size_t>(std::ranges::max_element(keys, {}, different) - keys.begin());
    const std::vector<std::string> names = names_of(finished);
    const bool measured = keys[along].is_temperature && std::ranges::find(names, "temperature") != names.end();
    if (!keys[along].numbers.empty()) {
        sort_points(finished, measured ? numbers(finished, "temperature",
                                                 [](const Quantity& q) { return std::optional(q.value); })
                                       : keys[along].numbers);
        keys = keys_of(plan, finished);
    }
    const VariedKey& key = keys[along];
    const PageTable table = points_table(finished, keys, along);
    page.tables.push_back(table);
    const std::string x = measured ? "temperature" : column_of(key);
    const Axis axis{measured ? axis_label("temperature") : key.heading, key.numbers.empty() ? "category" : "linear"};
    const std::vector<double> places =
        measured ? numbers(finished, "temperature", [](const Quantity& q) { return std::optional(q.value); })
                 : key.numbers;
    const PageTable curves = equation_curves(
        x, places.empty() ? std::vector<StateOnAxis>() : states_of(finished, places, series_of(keys, along)));
    if (!curves.columns.empty()) {
        page.tables.push_back(curves);
    }
    constexpr std::size_t leading = 2;
    std::size_t drawn = 0;
    for (const std::string& name : drawn_names(finished)) {
        if (!table.has_column(name) || (name == "temperature" && key.is_temperature)) {
            continue;
        }
        page.charts.push_back(line_chart(table, curves, name, x, axis, equation_of(finished)));
        page.charts.back().lead = drawn < leading;
        const VariedKey& other = keys[along == 0 ? keys.size() - 1 : 0];
        if (keys.size() == 2 && key.different > 2 && other.different > 2) {
            page.charts.push_back(map_chart(name, key, other));
            page.charts.back().lead = drawn < leading;
        }
        ++drawn;
    }
}

}  // namespace

PageContent sweep_page(const fs::path& directory) {
    const auto plan = recorded_sweep(directory);
    if (!plan) {
        throw DataError(fmt::format("{} is not the directory of a sweep", directory.string()));
    }
    PageContent page{.kind = "sweep",
                     .title = fmt::format("Sweep of {}", plan->deck_file),
                     .source = directory.string(),
                     .downloads = {{"deck", plan->deck}}};
    const Data study = study_report(directory).data;
    add_study_state(page, study);
    page.points = study_points(study["runs"], directory);
    Finished finished;
    const std::vector<ChildRun> runs = sweep_runs(*plan, directory);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        if (input_is_there(runs[k].directory / "results.json")) {
            add_if_readable(page.warnings, [&] {
                add_point(finished, runs[k].directory);
                finished.values.push_back(plan->points.values[k]);
            });
        }
    }
    for (const Data& run : study["runs"].items()) {
        if (const std::string words = text_in(run, {"words"}); !words.empty()) {
            page.warnings.push_back(fmt::format("{}: {}", text_in(run, {"name"}), words));
        }
    }
    if (!finished.values.empty()) {
        add_points(page, *plan, std::move(finished));
    }
    return page;
}

}  // namespace ljmd
