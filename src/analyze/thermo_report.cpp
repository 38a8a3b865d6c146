#include "ljmd/analyze/thermo_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/text.hpp"
#include "ljmd/core/text_table.hpp"
#include "ljmd/deck/deck_system.hpp"
#include "ljmd/deck/sampled_steps.hpp"
#include "ljmd/io/tables/data_table_csv.hpp"
#include "ljmd/observables/response/response_functions.hpp"
#include "ljmd/run/footnotes.hpp"
#include "ljmd/run/results.hpp"

namespace ljmd {

namespace {

using Align = TextTable::Align;

constexpr Index max_starts = 100;  // candidate start rows of a series
/// The edges where a barostat changes each by itself.
constexpr std::array<const char*, 7> reported{"temperature", "potential_energy", "total_energy", "pressure",
                                              "edge_x",      "edge_y",           "edge_z"};

Estimate blocking(const std::vector<double>& series) {
    BlockingAccumulator blocks(1, Covariance::diagonal);
    for (const double value : series) {
        blocks.add(Eigen::VectorXd::Constant(1, value));
    }
    return blocks.estimate(0);
}

/// The number of atoms, which thermo.csv does not contain; nothing if the start file of the run is gone.
std::optional<Index> atoms_of(const Deck& deck) {
    try {
        return find_start(deck).atoms;
    } catch (const DataError&) {
        return std::nullopt;
    }
}

/// Heat capacity from the fluctuations of temperature and potential energy.
std::optional<ObservableAverage> heat_capacity(const DataTable& table, const Deck& deck) {
    const auto atoms = atoms_of(deck);
    if (!atoms) {
        return std::nullopt;
    }
    RunAverages averages(*atoms, sampled_ensemble(deck.stages));
    const std::vector<double> temperatures = column(table, "temperature");
    const std::vector<double> energies = column(table, "potential_energy");
    for (std::size_t k = 0; k < energies.size(); ++k) {
        Thermodynamics row;
        row.temperature = temperatures[k];
        row.potential_energy = energies[k];
        averages.add(row);
    }
    for (const ObservableAverage& average : averages.averages()) {
        if (average.name == "heat_capacity_cv") {
            return average;
        }
    }
    return std::nullopt;
}

/// Response functions that the columns determine: all of them where a barostat lets the volume fluctuate; under a
/// thermostat alone the pressure coefficient.
std::vector<ObservableAverage> responses(const DataTable& table, const Deck& deck) {
    const auto atoms = atoms_of(deck);
    const Ensemble ensemble = sampled_ensemble(deck.stages);
    const bool isobaric = ensemble == Ensemble::isothermal_isobaric;
    // The energy of a plain cut is not the one that the forces belong to, see SampledResponses.
    const bool is_cut = deck.potential().truncation == "cut";
    if (!atoms || is_cut || !deck.given.external.empty() || (!isobaric && ensemble != Ensemble::canonical)) {
        return {};
    }
    const auto held = isobaric
                          ? std::optional(deck.stages[first_sampled(deck.stages)].barostat->options->held_pressure())
                          : std::nullopt;
    ResponseFunctions responses(*atoms, ensemble, held, false);
    const std::vector<double> temperatures = column(table, "temperature");
    const std::vector<double> energies = column(table, "potential_energy");
    const std::vector<double> pressures = column(table, "pressure");
    // A column only where a barostat changes it.
    const bool has_densities = std::ranges::find(table.columns, "density") != table.columns.end();
    const std::vector<double> densities =
        has_densities
            ? column(table, "density")
            : std::vector<double>(energies.size(), static_cast<double>(*atoms) / find_start(deck).box.volume());
    for (std::size_t k = 0; k < energies.size(); ++k) {
        const double t = temperatures[k];
        const double rho = densities[k];
        responses.add({t, energies[k], pressures[k] - rho * t, 1.0 / rho, 0.0});
    }
    std::vector<ObservableAverage> found = responses.observables();
    std::erase_if(
        found, [&](const ObservableAverage& each) { return !isobaric && each.name != "thermal_pressure_coefficient"; });
    return found;
}

/// With fewer independent rows the error bar is unreliable, see BlockingAccumulator.
constexpr double few_samples = 16.0;

std::string remark_on(const Equilibration& found) {
    return found.independent_samples < few_samples ? std::string(guessed_error) : "";
}

/// The mark after a number; empty for an empty mark.
std::string spaced(const std::string& mark) {
    return mark.empty() ? "" : " " + mark;
}

/// "heat capacity", "thermal expansion": its name without the symbol.
std::string in_words(const ObservableAverage& average) {
    std::string words =
        average.name == "heat_capacity_cv" || average.name == "heat_capacity_cp" ? "heat_capacity" : average.name;
    std::ranges::replace(words, '_', ' ');
    return words;
}

/// (g - 1)/2 rows, as a time.
double correlation_time(const ThermoReport& report, const Equilibration& found) {
    return 0.5 * (found.inefficiency - 1.0) * report.interval;
}

Index step_of_row(const ThermoReport& report, Index row) {
    return report.first_step + row * ((report.last_step - report.first_step) / std::max(report.rows - 1, Index{1}));
}

std::vector<std::string> table_line(const ThermoReport& report, const ThermoReport::Column& column,
                                    Footnotes& footnotes) {
    const Equilibration& found = column.found;
    if (!std::isfinite(found.inefficiency)) {
        return {column.name, "not defined"};
    }
    return {column.name,
            fmt::format("{}", step_of_row(report, found.start)),
            fmt::format("{:.3g} tau", correlation_time(report, found)),
            fmt::format("{:.0f}", found.independent_samples),
            with_error(found.mean, found.standard_error),
            footnotes.mark(remark_on(found))};
}

Data column_data(const ThermoReport& report, const ThermoReport::Column& column) {
    const Equilibration& found = column.found;
    Data data = {{"equilibrated_at_row", found.start},
                 {"equilibrated_at_step", step_of_row(report, found.start)},
                 {"statistical_inefficiency", found.inefficiency},
                 {"correlation_time", correlation_time(report, found)},
                 {"independent_samples", found.independent_samples},
                 {"mean", found.mean},
                 {"standard_error", found.standard_error},
                 {"statistical_inefficiency_of_all", column.whole_inefficiency},
                 {"mean_of_all", column.by_blocking.mean},
                 {"blocking_standard_error_of_all", column.by_blocking.standard_error}};
    if (const std::string remark = remark_on(found); !remark.empty()) {
        data["remark"] = remark;
    }
    return data;
}

}  // namespace

ThermoReport thermo_report(const RecordedRun& run, std::optional<double> from) {
    require_fluid(run.deck, "a few-body run has no equilibrium: `ljmd analyze` wants one of a fluid");
    const std::filesystem::path path = run.deck.directory / "thermo.csv";
    DataTable table = read_growing_csv(path);
    const SampledSteps sampled(run.deck.stages);
    const std::vector<Index> all_steps = step_column(table, path);
    const std::vector<double> all_times = full_column(table, "time", path);
    std::size_t row = 0;
    std::erase_if(table.rows, [&](const auto&) {
        const std::size_t k = row++;
        return !sampled.contain(all_steps[k]) || (from && is_before(all_times[k], *from));
    });
    const auto rows = static_cast<Index>(table.rows.size());
    if (rows < 2) {
        throw DataError(fmt::format("{} has {} of the rows that are looked at: the sampled stages have hardly begun",
                                    path.string(), rows));
    }
    const std::vector<Index> steps = step_column(table, path);
    const std::vector<double> times = column(table, "time");
    ThermoReport report{rows,
                        steps.front(),
                        steps.back(),
                        (times.back() - times.front()) / static_cast<double>(rows - 1),
                        std::max(rows / max_starts, Index{1}),
                        {},
                        {}};
    if (const auto capacity = heat_capacity(table, run.deck)) {
        report.of_fluctuations.push_back(*capacity);
    }
    std::ranges::move(responses(table, run.deck), std::back_inserter(report.of_fluctuations));
    for (const char* name : reported) {
        const bool is_edge = std::string_view(name).starts_with("edge_");
        if (is_edge && std::ranges::find(table.columns, name) == table.columns.end()) {
            continue;
        }
        const std::vector<double> series = column(table, name);
        report.columns.push_back(
            {name, detect_equilibration(series, report.stride), statistical_inefficiency(series), blocking(series)});
    }
    return report;
}

Document thermo_document(const ThermoReport& report) {
    Footnotes footnotes;
    TextTable table({{"observable", Align::left, 16},
                     {"equilibrated at step", Align::right, 20},
                     {"correlation time", Align::right, 16},
                     {"independent", Align::right, 12},
                     {"mean +- standard error", Align::right, 24},
                     {"", Align::left}},
                    2);
    Data observables = Data::object();
    for (const ThermoReport::Column& column : report.columns) {
        table.add(table_line(report, column, footnotes));
        observables[column.name] = column_data(report, column);
    }
    Document document{{{"rows", report.rows},
                       {"first_step", report.first_step},
                       {"last_step", report.last_step},
                       {"interval", report.interval},
                       {"stride", report.stride},
                       {"observables", observables}},
                      fmt::format("{} rows of thermo.csv, steps {} to {}, {:.6g} tau apart\n\n{}", report.rows,
                                  report.first_step, report.last_step, report.interval, table.text())};
    for (const ObservableAverage& each : report.of_fluctuations) {
        const auto& estimate = each.estimate;
        const std::string value =
            estimate ? with_error(estimate->mean, estimate->standard_error) + " " + each.unit : "no value";
        document.text += fmt::format("  {} {} of all rows, from their fluctuations: {}{}\n", in_words(each),
                                     each.symbol, value, spaced(footnotes.mark(each.remark)));
        document.data[each.name] = observables_data({each}, std::nullopt).at(each.name);
    }
    document.text += footnotes.text();
    return document;
}

}  // namespace ljmd
