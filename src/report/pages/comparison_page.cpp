#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "compare/recorded_comparison.hpp"
#include "io/files/input_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "report/lenient_data.hpp"
#include "report/pages/study_pages.hpp"
#include "report/quantity_names.hpp"
#include "report/run_charts.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

void add_checks(PageContent& page, const Data& results) {
    std::vector<std::string> names;
    std::vector<double> values;
    std::vector<double> tolerances;
    std::vector<double> ratios;
    Data::List failed;
    std::size_t failures = 0;
    for (const Data& check : results.at("checks").items()) {
        const double value = number_in(check, {"value"}).value_or(std::nan(""));
        const double tolerance = number_in(check, {"tolerance"}).value_or(std::nan(""));
        const bool passed = flag_in(check, {"passed"}) == true;
        names.push_back(text_in(check, {"name"}));
        values.push_back(value);
        tolerances.push_back(tolerance);
        ratios.push_back(value > 0.0 ? value / tolerance : std::nan(""));  // exact agreement has no logarithm
        failed.emplace_back(!passed);
        failures += passed ? 0 : 1;
    }
    const std::size_t count = names.size();
    page.verdicts.push_back({"agreement",
                             count == 0      ? "unknown"
                             : failures == 0 ? "good"
                                             : "bad",
                             count == 0      ? std::string("Nothing was judged.")
                             : failures == 0 ? fmt::format("All {} checks are within their tolerances.", count)
                                             : fmt::format("{} of {} checks failed.", failures, count)});
    PageTable table{.name = "checks", .title = "Checks", .lead = true, .flag = "failed"};
    table.add({"check"}, names);
    table.add({"value", "found"}, values);
    table.add({"tolerance", "allowed"}, tolerances);
    table.add({"ratio", "found / allowed"}, ratios);
    table.add({"failed"}, std::move(failed));
    page.tables.push_back(std::move(table));
    page.charts.push_back(
        {.id = "checks",
         .title = "Checks against their tolerances",
         .caption = "Difference in units of what is allowed: below 1 a check passes. Exact agreement is not drawn.",
         .lead = true,
         .x = {"found / allowed", "log"},
         .y = {"check", "category"},  // their names are long
         .marks = {
             {.type = "rule-x", .label = "allowed", .value = 1.0, .colour = 7},
             {.type = "dots", .label = "found", .table = "checks", .x = "ratio", .y = "check", .flag = "failed"}}});
}

/// d(t) = d_0 exp(rate t) through the distances that grow exponentially.
std::vector<double> fitted(const std::vector<double>& times, const std::vector<double>& distances, double rate) {
    constexpr double rounding = 1e-12;  // below, distances are differences of last digits
    constexpr double saturation = 0.1;  // above, trajectories know nothing of each other
    double sum = 0.0;
    int count = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        if (distances[k] > rounding && distances[k] < saturation) {
            sum += std::log(distances[k]) - rate * times[k];
            ++count;
        }
    }
    std::vector<double> line;
    for (const double time : times) {
        const double value = count == 0 ? std::nan("") : std::exp(sum / count + rate * time);
        line.push_back(value < 1.0 ? value : std::nan(""));
    }
    return line;
}

void add_trajectories(PageContent& page, const fs::path& file, const std::optional<double>& rate) {
    const DataTable found = read_csv(file);
    PageTable table = page_table(found, "Distance of the trajectories", file.filename().string());
    table.name = "trajectory";
    Chart chart{.id = "divergence",
                .title = "Divergence of the trajectories",
                .caption = rate ? fmt::format("Largest distance of an atom in two trajectories from the same start. "
                                              "They part like exp({:.2f} t).",
                                              *rate)
                                : std::string("Largest distance of an atom in two trajectories from the same start."),
                .lead = true,
                .x = {axis_label("time")},
                .y = {"distance / sigma", "log"}};
    int colour = 0;
    std::string first;
    for (const std::string& name : found.columns) {
        if (name.find(" - ") != std::string::npos) {
            first = first.empty() ? name : first;
            chart.marks.push_back(
                {.type = "line", .label = name, .table = "trajectory", .x = "time", .y = name, .colour = colour++ % 7});
        }
    }
    if (rate && !first.empty()) {
        table.add({"fit", "exponential"}, fitted(column(found, "time"), column(found, first), *rate));
        chart.marks.push_back(
            {.type = "line", .label = "exponential", .table = "trajectory", .x = "time", .y = "fit", .colour = 7});
    }
    page.tables.push_back(std::move(table));
    page.charts.push_back(std::move(chart));
}

void add_rdf(PageContent& page, const fs::path& file) {
    const DataTable found = read_csv(file);
    DataTable difference{"rdf", {"r", "g_ljmd", "g_peer", "difference", "difference_standard_error"}, {}};
    const std::vector<double> r = column(found, "r");
    const std::vector<double> ours = column(found, "g_ljmd");
    const std::vector<double> our_error = column(found, "g_ljmd_standard_error");
    const std::vector<double> theirs = column(found, "g_peer");
    const std::vector<double> their_error = column(found, "g_peer_standard_error");
    for (std::size_t k = 0; k < r.size(); ++k) {
        difference.rows.push_back(
            {r[k], ours[k], theirs[k], ours[k] - theirs[k], std::hypot(our_error[k], their_error[k])});
    }
    page.tables.push_back(page_table(difference, "Radial distribution functions", file.filename().string()));
    page.charts.push_back(
        {.id = "rdf",
         .title = "Radial distribution functions",
         .caption = "",
         .x = {axis_label("r")},
         .y = {axis_label("g")},
         .marks = {
             {.type = "line", .label = "ljmd", .table = "rdf", .x = "r", .y = "g_ljmd"},
             {.type = "line", .label = "the other program", .table = "rdf", .x = "r", .y = "g_peer", .colour = 1}}});
    page.charts.push_back(
        {.id = "rdf-difference",
         .title = "Difference of g(r)",
         .caption = "The band is one standard error on either side.",
         .x = {axis_label("r")},
         .y = {"g(r) of ljmd - g(r) of the other"},
         .marks = {{.type = "rule-y", .label = "no difference", .value = 0.0, .colour = 7},
                   {.type = "band",
                    .label = "standard error",
                    .table = "rdf",
                    .x = "r",
                    .y = "difference",
                    .error = "difference_standard_error"},
                   {.type = "line", .label = "difference", .table = "rdf", .x = "r", .y = "difference"}}});
}

/// Errors against a reference solution, of few bodies.
void add_errors(PageContent& page, const fs::path& file) {
    PageTable table = page_table(read_csv(file), "Errors against the reference", file.filename().string());
    table.name = "errors";
    Chart chart{
        .id = "errors",
        .title = "Errors against the reference",
        .caption = "Absolute, in the deck's units; reference: how far two references of different tolerance are apart.",
        .lead = true,
        .x = {"t"},
        .y = {"error", "log"}};
    int colour = 0;
    for (const PageColumn& column : table.columns) {
        if (column.name.ends_with("_error")) {
            chart.marks.push_back({.type = "line",
                                   .label = in_plain_words(column.name),
                                   .table = "errors",
                                   .x = "time",
                                   .y = column.name,
                                   .colour = colour++});
        }
    }
    page.tables.push_back(std::move(table));
    page.charts.push_back(std::move(chart));
}

/// The other program in a few words: an engine by the name that it gives itself, as its command may be long.
std::string peer_of(const Data& results) {
    return text_in(results, {results.contains("diagnoses") ? "peer" : "with"});
}

/// The first letter in upper case, and a full stop.
std::string as_sentence(std::string words) {
    if (!words.empty()) {
        words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    }
    return words + '.';
}

void add_averages(PageContent& page, const Data& results) {
    const Data* observables = value_in(results, {"averages", "observables"});
    if (observables == nullptr || !observables->is_object()) {
        return;
    }
    for (const auto& [name, entry] : observables->members()) {
        page.quantities.push_back({.name = name,
                                   .symbol = symbol_of(name),
                                   .value = number_in(entry, {"ljmd", "mean"}).value_or(std::nan("")),
                                   .error = number_in(entry, {"ljmd", "standard_error"}),
                                   .unit = described(name).unit,
                                   .reference = number_in(entry, {"peer", "mean"}),
                                   .reference_error = number_in(entry, {"peer", "standard_error"}),
                                   .reference_label = peer_of(results)});
    }
}

/// What a judgement of an engine has beside checks: the mistakes that explain them, and what was not judged.
void add_judgement(PageContent& page, const Data& results) {
    const auto texts = [&](const char* key) {
        std::vector<std::string> found;
        if (const Data* list = results.find(key); list != nullptr && list->is_list()) {
            for (const Data& item : list->items()) {
                found.push_back(item.text());
            }
        }
        return found;
    };
    for (const std::string& words : texts("diagnoses")) {
        page.verdicts.push_back({"diagnosis", "bad", as_sentence(words)});
    }
    if (flag_in(results, {"passed"}) == false && texts("diagnoses").empty() && results.contains("diagnoses")) {
        page.verdicts.push_back({"diagnosis", "unknown", "No mistake that is known explains what failed."});
    }
    for (const std::string& words : texts("not_judged")) {
        page.verdicts.push_back({"not judged", "unknown", as_sentence(words)});
    }
    for (const std::string& words : texts("warnings")) {
        page.warnings.push_back(words);
    }
}

/// How far an engine's trajectory is from ljmd's, and its forces from those at its own positions.
void add_steps(PageContent& page, const Data& steps) {
    std::vector<double> times;
    std::vector<double> distances;
    std::vector<double> allowed;
    std::vector<double> forces;
    const auto positive = [](const std::optional<double>& number) {  // exact agreement has no logarithm
        return number && *number > 0.0 ? *number : std::nan("");
    };
    for (const Data& step : steps.items()) {
        times.push_back(number_in(step, {"time"}).value_or(std::nan("")));
        distances.push_back(positive(number_in(step, {"distance"})));
        allowed.push_back(positive(number_in(step, {"allowed_distance"})));
        forces.push_back(positive(number_in(step, {"force_difference"})));
    }
    if (times.empty()) {
        return;
    }
    PageTable table{.name = "trajectory", .title = "Trajectory of the engine"};
    table.add({"time", "t", "tau"}, times);
    table.add({"distance", "distance", "sigma"}, distances);
    table.add({"allowed", "allowed distance", "sigma"}, allowed);
    table.add({"force_difference", "difference of forces"}, forces);
    page.tables.push_back(std::move(table));
    const auto chart = [&](const char* id, const char* title, const char* caption, const char* axis, int colour) {
        page.charts.push_back(
            {.id = id,
             .title = title,
             .caption = caption,
             .lead = true,
             .x = {axis_label("time")},
             .y = {axis, "log"},
             .marks = {
                 {.type = "line", .label = axis, .table = "trajectory", .x = "time", .y = id, .colour = colour},
                 {.type = "dots", .label = axis, .table = "trajectory", .x = "time", .y = id, .colour = colour}}});
    };
    chart("distance", "Divergence of the trajectories",
          "Largest distance of an atom in two trajectories from the same start, at the judged steps. Rounding errors "
          "grow exponentially, so that two right programs part, too; later nothing is demanded.",
          "distance / sigma", 0);
    page.charts.back().marks.push_back(
        {.type = "dots", .label = "allowed", .table = "trajectory", .x = "time", .y = "allowed", .colour = 7});
    chart("force_difference", "Forces at the engine's own positions",
          "Largest difference over the root mean square of the forces: it stays at the rounding errors if formula and "
          "neighbour list are right, wherever the atoms are.",
          "difference of forces", 1);
}

}  // namespace

PageContent comparison_page(const fs::path& directory) {
    const std::vector<fs::path> found = comparison_results(directory);
    if (found.empty()) {
        throw DataError(fmt::format("{} holds no comparison", directory.string()));
    }
    const fs::path& file = found.front();
    const Data results = read_any_json(file);
    const std::string name = file.stem().string();
    PageContent page{.kind = "comparison",
                     .title = fmt::format("{} against {}", text_in(results, {"deck"}), peer_of(results)),
                     .source = directory.string(),
                     .state_words = results.contains("diagnoses") ? "an engine, judged" : "a comparison"};
    for (const char* key :
         {"deck", "with", "peer", "peer_of_long_runs", "atoms", "steps_before", "pressure_convention"}) {
        if (const std::string text = text_in(results, {key}); !text.empty()) {
            page.provenance.emplace_back(in_plain_words(key), text);
        }
    }
    for (std::size_t k = 1; k < found.size(); ++k) {
        page.warnings.push_back(fmt::format("{} is another comparison, and not shown", found[k].string()));
    }
    add_if_readable(page.warnings, [&] { add_checks(page, results); });
    add_if_readable(page.warnings, [&] { add_judgement(page, results); });
    if (const Data* steps = value_in(results, {"trajectory", "steps"}); steps != nullptr && steps->is_list()) {
        add_if_readable(page.warnings, [&] { add_steps(page, *steps); });
    }
    add_averages(page, results);
    const auto with_file = [&](const std::string& suffix, const auto& use) {
        const fs::path path = directory / (name + suffix);
        if (input_is_there(path)) {
            add_if_readable(page.warnings, [&] { use(path); });
        }
    };
    with_file(".csv", [&](const fs::path& path) { add_errors(page, path); });
    with_file("-trajectory.csv", [&](const fs::path& path) {
        add_trajectories(page, path, number_in(results, {"trajectory", "divergence_rate"}));
    });
    with_file("-rdf.csv", [&](const fs::path& path) { add_rdf(page, path); });
    return page;
}

}  // namespace ljmd
