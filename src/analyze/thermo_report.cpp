#include "analyze/thermo_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <span>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "deck/deck_system.hpp"
#include "deck/fluid.hpp"
#include "deck/sampled_steps.hpp"
#include "engine/errors_to_reach.hpp"
#include "io/tables/data_table_csv.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/observables/statistics/run_averages.hpp"
#include "model/velocities.hpp"
#include "observables/response/response_functions.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "run/footnotes.hpp"
#include "run/results.hpp"

namespace ljmd {

namespace {

using Align = TextTable::Align;

/// Volume and edges where a barostat changes them.
constexpr std::array<const char*, 8> reported{"temperature", "potential_energy", "total_energy", "pressure",
                                              "density",     "edge_x",           "edge_y",       "edge_z"};
constexpr std::string_view still_changing = "it still changes in the second half of the rows";

Estimate blocking(std::span<const double> series) {
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

bool has_column(const DataTable& table, std::string_view name) {
    return std::ranges::find(table.columns, name) != table.columns.end();
}

/// Of each row: a column only where a barostat changes them. Not a number if the number of atoms is unknown.
std::vector<double> densities_of(const DataTable& table, const Deck& deck, const std::optional<Index>& atoms) {
    if (has_column(table, "density")) {
        return column(table, "density");
    }
    const double density =
        atoms ? static_cast<double>(*atoms) / find_start(deck).box.volume() : std::numeric_limits<double>::quiet_NaN();
    return std::vector<double>(table.rows.size(), density);
}

/// Whether nothing but the integrator changes the total energy of the rows.
bool energy_is_conserved(const Deck& deck) {
    const SampledSteps sampled(deck.stages());
    Index last = 0;
    return deck.given.external.empty() && std::ranges::all_of(deck.stages(), [&](const Stage& stage) {
               last += stage.steps;
               return stage.steps == 0 || !sampled.contain(last) || (!stage.thermostat && !stage.barostat);
           });
}

/// Averages of rows of thermo.csv, by the rules of the run's own results.
class RowAverages {
  public:
    RowAverages(const DataTable& table, const RecordedRun& run)
        : table_(table), run_(run), atoms_(atoms_of(run.deck)), rows_(samples()) {}

    /// Of a column; a guess where the run itself marks it.
    [[nodiscard]] ObservableAverage of(const std::string& name, Index start) {
        const std::vector<ObservableAverage>& all = from(start);
        const auto found = std::ranges::find(all, name, &ObservableAverage::name);
        if (found != all.end()) {
            return *found;
        }
        const std::vector<double> series = column(table_, name);
        return {name, symbol_of(name), "", blocking(std::span(series).subspan(static_cast<std::size_t>(start)))};
    }

    /// From the fluctuations of temperature and energy. Without the number of atoms there is none.
    [[nodiscard]] std::optional<ObservableAverage> heat_capacity() {
        const std::vector<ObservableAverage>& all = from(0);
        const auto found = std::ranges::find(all, "heat_capacity_cv", &ObservableAverage::name);
        return atoms_ && found != all.end() ? std::optional(*found) : std::nullopt;
    }

  private:
    [[nodiscard]] std::vector<Thermodynamics> samples() const {
        const std::vector<double> temperatures = column(table_, "temperature");
        const std::vector<double> potential = column(table_, "potential_energy");
        const std::vector<double> kinetic = column(table_, "kinetic_energy");
        const std::vector<double> total = column(table_, "total_energy");
        const std::vector<double> pressures = column(table_, "pressure");
        const std::vector<double> xy = column(table_, "pressure_xy");
        const std::vector<double> xz = column(table_, "pressure_xz");
        const std::vector<double> yz = column(table_, "pressure_yz");
        const std::vector<double> densities = densities_of(table_, run_.deck, atoms_);
        const TailCorrection tail = fluid_spec(run_.deck).interaction().tail;
        std::vector<Thermodynamics> rows(temperatures.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            rows[k].temperature = temperatures[k];
            rows[k].potential_energy = potential[k];
            rows[k].kinetic_energy = kinetic[k];
            rows[k].total_energy = total[k];
            rows[k].pressure = pressures[k];
            if (std::isfinite(xy[k])) {  // a single atom has none
                rows[k].pressure_tensor = Mat3{{0.0, xy[k], xz[k]}, {0.0, 0.0, yz[k]}, {0.0, 0.0, 0.0}};  // the shear
            }
            rows[k].density = densities[k];
            // Not its virial, but 0 like that in samples where no atoms meet.
            const double far = tail.energy(densities[k]);
            const double near = potential[k] - far;
            rows[k].virial = std::abs(near) <= 1e-12 * std::abs(far) ? 0.0 : near;
        }
        return rows;
    }

    const std::vector<ObservableAverage>& from(Index start) {
        const auto known = averages_.find(start);
        if (known != averages_.end()) {
            return known->second;
        }
        const Deck& deck = run_.deck;
        RunAverages averages(atoms_.value_or(2), sampled_ensemble(deck.stages(), !deck.given.external.empty()), false,
                             sampled_baths(deck.stages(), deck.sample_every()));
        std::for_each(rows_.begin() + start, rows_.end(), [&](const Thermodynamics& row) { averages.add(row); });
        std::vector<ObservableAverage> found = averages.averages();
        if (run_.finished) {
            widen_wanted(found, deck.stages().back().until);
        }
        return averages_[start] = std::move(found);
    }

    const DataTable& table_;
    const RecordedRun& run_;
    std::optional<Index> atoms_;
    std::vector<Thermodynamics> rows_;
    std::map<Index, std::vector<ObservableAverage>> averages_;
};

/// Response functions that the columns determine: all of them where a barostat lets the volume fluctuate; under a
/// thermostat alone the pressure coefficient.
std::vector<ObservableAverage> responses(const DataTable& table, const Deck& deck) {
    const auto atoms = atoms_of(deck);
    const Ensemble ensemble = sampled_ensemble(deck.stages());
    const bool isobaric = ensemble == Ensemble::isothermal_isobaric;
    // The energy of a plain cut is not the one that the forces belong to, see SampledResponses.
    const bool is_cut = deck.potential().truncation == "cut";
    if (!atoms || is_cut || !deck.given.external.empty() || (!isobaric && ensemble != Ensemble::canonical)) {
        return {};
    }
    const auto held = isobaric ? held_pressure(deck.stages()[first_sampled(deck.stages())]) : std::nullopt;
    ResponseFunctions responses(*atoms, ensemble, held, false);
    const std::vector<double> temperatures = column(table, "temperature");
    const std::vector<double> energies = column(table, "potential_energy");
    const std::vector<double> pressures = column(table, "pressure");
    const std::vector<double> densities = densities_of(table, deck, atoms);
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

/// Rows that count as one independent row.
double inefficiency(const Estimate& estimate) {
    return static_cast<double>(estimate.samples) / estimate.independent_samples;
}

std::string remark_on(const ThermoReport::Column& column) {
    const std::string remark = remark_of(column.average);
    if (!column.found.changes) {
        return remark;
    }
    return remark.empty() ? std::string(still_changing) : fmt::format("{}; {}", still_changing, remark);
}

std::vector<std::string> table_line(const ThermoReport& report, const ThermoReport::Column& column,
                                    Footnotes& footnotes) {
    if (!column.average.estimate || !std::isfinite(column.average.estimate->mean)) {
        return {column.average.name, "not defined"};
    }
    const Estimate& estimate = *column.average.estimate;
    const auto step = equilibrated_at_step(report, column);
    const auto time = correlation_time(report, column);
    return {column.average.name,
            step ? fmt::format("{}", *step) : state_of(column),
            time ? fmt::format("{:.3g} tau", *time) : "-",
            std::isfinite(estimate.independent_samples) ? fmt::format("{:.0f}", estimate.independent_samples) : "-",
            with_error(estimate.mean, estimate.standard_error),
            footnotes.mark(remark_on(column))};
}

Data column_data(const ThermoReport& report, const ThermoReport::Column& column) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const Estimate estimate = column.average.estimate.value_or(Estimate{unknown, unknown, unknown, 0, false});
    const Estimate all = column.of_all.estimate.value_or(estimate);
    Data data = {{"equilibrium", state_of(column)},
                 {"equilibrated_at_row", column.found.start},
                 {"equilibrated_at_step", equilibrated_at_step(report, column)},
                 {"statistical_inefficiency", inefficiency(estimate)},
                 {"correlation_time", correlation_time(report, column)},
                 {"independent_samples", estimate.independent_samples},
                 {"mean", estimate.mean},
                 {"standard_error", estimate.standard_error},
                 {"error_is_converged", estimate.converged},
                 {"statistical_inefficiency_of_all", column.whole_inefficiency},
                 {"mean_of_all", all.mean},
                 {"blocking_standard_error_of_all", all.standard_error}};
    if (const std::string remark = remark_on(column); !remark.empty()) {
        data["remark"] = remark;
    }
    return data;
}

/// The columns that the report has, without those that the run's table lacks.
std::vector<std::string> reported_columns(const DataTable& table) {
    std::vector<std::string> names;
    for (const std::string name : reported) {
        const bool is_of_box = name == "density" || name.starts_with("edge_");
        if (!is_of_box || has_column(table, name)) {
            names.push_back(name);
        }
    }
    return names;
}

/// A conserved energy has nothing to relax, and tells nothing about the others.
std::vector<Equilibration> equilibrations(const std::vector<std::string>& names,
                                          const std::vector<std::vector<double>>& columns, bool energy_conserved,
                                          const std::optional<Index>& atoms) {
    // Energy and volume that a bath exchanges are the slowest: what they do shows in these as well, beside what is
    // fast.
    const std::set<std::string> judged{"temperature", "potential_energy", "pressure"};
    std::vector<EquilibratingColumn> relaxing;
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (energy_conserved && names[k] == "total_energy") {
            continue;
        }
        relaxing.push_back({.series = columns[k], .judged = judged.contains(names[k])});
        if (names[k] == "temperature" && atoms) {
            relaxing.back().largest_relative_deviation =
                std::sqrt(2.0 / static_cast<double>(std::max(degrees_of_freedom(*atoms), Index{1})));
        }
    }
    std::vector<Equilibration> found = detect_equilibration(relaxing);
    if (energy_conserved) {
        const auto energy = std::ranges::find(names, "total_energy") - names.begin();
        found.insert(found.begin() + energy, {std::nullopt, false, std::numeric_limits<double>::quiet_NaN()});
    }
    return found;
}

}  // namespace

std::string state_of(const ThermoReport::Column& column) {
    if (column.conserved) {
        return "conserved";
    }
    if (column.found.changes) {
        return "still changing";
    }
    return column.found.start ? "found" : "too short to tell";
}

std::optional<double> correlation_time(const ThermoReport& report, const ThermoReport::Column& column) {
    const auto& estimate = column.average.estimate;
    if (column.conserved || !estimate || !std::isfinite(estimate->independent_samples)) {
        return std::nullopt;
    }
    return 0.5 * (inefficiency(*estimate) - 1.0) * report.interval;
}

std::optional<Index> equilibrated_at_step(const ThermoReport& report, const ThermoReport::Column& column) {
    const Index between = (report.last_step - report.first_step) / std::max(report.rows - 1, Index{1});
    return column.found.start ? std::optional(report.first_step + *column.found.start * between) : std::nullopt;
}

ThermoReport thermo_report(const RecordedRun& run, std::optional<double> from) {
    require_fluid(run.deck, "a few-body run has no equilibrium: `ljmd analyze` wants one of a fluid");
    const std::filesystem::path path = run.deck.directory / "thermo.csv";
    DataTable table = read_growing_csv(path);
    const SampledSteps sampled(run.deck.stages());
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
    ThermoReport report{
        rows, steps.front(), steps.back(), (times.back() - times.front()) / static_cast<double>(rows - 1), {}, {}};
    RowAverages averages(table, run);
    if (const auto capacity = averages.heat_capacity()) {
        report.of_fluctuations.push_back(*capacity);
    }
    std::vector<ObservableAverage> of_fluctuations = responses(table, run.deck);
    if (has_column(table, "density")) {  // which a barostat changes
        of_fluctuations.push_back(averages.of("density", 0));
        withhold_slow_responses(of_fluctuations);
        of_fluctuations.pop_back();
    }
    std::ranges::move(of_fluctuations, std::back_inserter(report.of_fluctuations));
    const std::vector<std::string> names = reported_columns(table);
    std::vector<std::vector<double>> series;
    std::ranges::transform(names, std::back_inserter(series),
                           [&](const std::string& name) { return column(table, name); });
    const bool energy_conserved = energy_is_conserved(run.deck);
    const std::vector<Equilibration> found = equilibrations(names, series, energy_conserved, atoms_of(run.deck));
    for (std::size_t k = 0; k < names.size(); ++k) {
        report.columns.push_back({averages.of(names[k], found[k].start.value_or(0)), averages.of(names[k], 0), found[k],
                                  energy_conserved && names[k] == "total_energy", statistical_inefficiency(series[k])});
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
        observables[column.average.name] = column_data(report, column);
    }
    Document document{{{"rows", report.rows},
                       {"first_step", report.first_step},
                       {"last_step", report.last_step},
                       {"interval", report.interval},
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
