#include "report/run_quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "deck/fluid.hpp"
#include "engine/mistakes/film_mistakes.hpp"
#include "io/files/input_file.hpp"
#include "io/tables/data_table_csv.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/engine/requested_temperature.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "observables/statistics/known_quantities.hpp"
#include "reference/equation_doubts.hpp"
#include "report/lenient_data.hpp"
#include "report/quantity_names.hpp"
#include "report/reference_errors.hpp"

namespace ljmd {

namespace {

Quantity quantity_of(const std::string& name, const Data& entry) {
    Quantity quantity{.name = name,
                      .symbol = symbol_of(name),
                      .value = number_in(entry, {"mean"}).value_or(std::nan("")),
                      .error = number_in(entry, {"standard_error"}),
                      .unit = text_in(entry, {"unit"}),
                      .samples = number_in(entry, {"independent_samples"}),
                      .remark = text_in(entry, {"remark"}),
                      .value_in_si = number_in(entry, {"si", "mean"}),
                      .error_in_si = number_in(entry, {"si", "standard_error"}),
                      .si_unit = text_in(entry, {"si", "unit"})};
    if (quantity.unit == "1") {
        quantity.unit.clear();
    }
    return quantity;
}

void add_observables(std::vector<Quantity>& quantities, const Data* observables, const std::string& suffix) {
    if (observables == nullptr || !observables->is_object()) {
        return;
    }
    for (const auto& [name, entry] : observables->members()) {
        const ObservableAverage average{name, "", "", std::nullopt, "", flag_in(entry, {"own"}).value_or(false)};
        if (is_in_table(average)) {
            quantities.push_back(quantity_of(name, entry));
            quantities.back().name += suffix;
        }
    }
}

Quantity* quantity_named(std::vector<Quantity>& quantities, const std::string& name) {
    const auto found = std::ranges::find(quantities, name, &Quantity::name);
    return found == quantities.end() ? nullptr : &*found;
}

constexpr std::array<ComparableProperty, 5> comparables{
    {{"potential_energy", &FluidProperties::potential_energy},
     {"pressure", &FluidProperties::pressure},
     {"compressibility_factor", &FluidProperties::compressibility_factor},
     {"heat_capacity_cv", &FluidProperties::heat_capacity_cv},
     {"excess_chemical_potential", &FluidProperties::excess_chemical_potential}}};

/// Of a run with tail correction that has measured g(r).
std::optional<BeyondCutoff> beyond_cutoff_of(const Deck& deck, const EquationOfState& equation,
                                             const std::filesystem::path& directory, double density) {
    const std::filesystem::path file = directory / "rdf.csv";
    if (!equation.full_potential || !input_is_there(file)) {
        return std::nullopt;
    }
    try {
        return beyond_cutoff(read_csv(file), fluid_spec(deck).potential.cutoff().radius, density);
    } catch (const DataError&) {
        return std::nullopt;  // its chart tells of what is wrong with the file
    }
}

}  // namespace

std::span<const ComparableProperty> comparable_properties() {
    return comparables;
}

std::vector<Quantity> quantities_in(const Data& results) {
    std::vector<Quantity> quantities;
    add_observables(quantities, value_in(results, {"observables"}), "");
    return quantities;
}

std::vector<Quantity> run_quantities(const RunFacts& facts, const std::optional<ThermoReport>& so_far) {
    std::vector<Quantity> quantities;
    if (!facts.results.is_null()) {
        add_observables(quantities, value_in(facts.results, {"observables"}), "");
        if (const auto at = number_in(facts.results, {"at_asked_temperature", "temperature"})) {
            add_observables(quantities, value_in(facts.results, {"at_asked_temperature", "observables"}),
                            fmt::format(" at T = {:.6g}", *at));
        }
    } else if (so_far) {
        for (const ThermoReport::Column& column : so_far->columns) {
            const ObservableAverage& all = column.of_all;
            if (!all.estimate) {
                continue;
            }
            const PageColumn name = described(all.name);
            quantities.push_back({.name = all.name,
                                  .symbol = name.label,
                                  .value = all.estimate->mean,
                                  .error = all.estimate->standard_error,
                                  .unit = name.unit,
                                  .samples = all.estimate->independent_samples,
                                  .remark = remark_of(all)});
        }
    }
    return quantities;
}

std::string add_references(std::vector<Quantity>& quantities, const Deck& deck, std::optional<double> density,
                           const std::filesystem::path& directory) {
    const FluidSpec spec = fluid_spec(deck);
    const auto equation = equation_of_fluid(spec);
    if (is_film(spec)) {
        return "a film has two phases; its densities and pressure are in the table";
    }
    if (!equation) {
        return "there is no equation of state of exactly this fluid";
    }
    const Quantity* temperature = quantity_named(quantities, "temperature");
    if (const Quantity* measured = quantity_named(quantities, "density")) {
        density = measured->value;
    }
    if (temperature == nullptr || !std::isfinite(temperature->value) || temperature->value <= 0.0 || !density) {
        return "there is no state to compare with an equation of state";
    }
    const double t = temperature->value;
    const double error = temperature->error.value_or(0.0);
    const std::vector<std::string> reasons = doubts(*equation, t, *density);
    if (!reasons.empty()) {
        return fmt::format("the equation of state {} is not reliable here: {}", equation->name, reasons.front());
    }
    const FluidProperties there = properties(*equation, t, *density);
    const FluidProperties warmer = properties(*equation, t + error, *density);
    const auto beyond = beyond_cutoff_of(deck, *equation, directory, *density);
    for (const auto& [name, property] : comparables) {
        if (Quantity* found = quantity_named(quantities, name)) {
            const double of_temperature = std::abs(warmer.*property - there.*property);
            const double of_equation = difference_of_equations(*equation, t, *density, property);
            double of_cutoff = 0.0;
            if (beyond && property == &FluidProperties::potential_energy) {
                of_cutoff = beyond->energy;
            } else if (beyond && property == &FluidProperties::pressure) {
                of_cutoff = beyond->pressure;
            } else if (beyond && property == &FluidProperties::compressibility_factor) {
                of_cutoff = beyond->pressure / (t * *density);
            }
            found->reference = there.*property;
            found->reference_error = std::hypot(of_temperature, of_equation, of_cutoff);
            found->reference_label = equation->name;
        }
    }
    return equation->name;
}

}  // namespace ljmd
