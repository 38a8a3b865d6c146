#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analyze/thermo_report.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"
#include "report/run_facts.hpp"

namespace ljmd {

/// The quantities of a fluid's results.json that tables show, beside an equation of state of the same fluid where there
/// is one; those that were brought to the requested temperature come last.
/// @param so_far  used while there are no results: means of all sampled rows of thermo.csv
[[nodiscard]] std::vector<Quantity> run_quantities(const RunFacts& facts, const std::optional<ThermoReport>& so_far);

/// The observables of a results.json that tables show.
[[nodiscard]] std::vector<Quantity> quantities_in(const Data& results);

/// The property that an equation of state has for an observable.
struct ComparableProperty {
    const char* name;  ///< of the observable
    double FluidProperties::*property;
};
[[nodiscard]] std::span<const ComparableProperty> comparable_properties();

/// Add the values of an equation of state at the measured temperature and density. Does nothing if there is no equation
/// of this fluid, or if it is not reliable there. Their errors, as standard deviations, are known ones: the measured
/// temperature's, the difference of two equations, and what g(r) does beyond the cutoff, see reference_errors.hpp.
/// @param density    of a run at constant volume; with a barostat the measured one counts
/// @param directory  of the run, whose rdf.csv is looked at if there is one
/// @return why there are none, or from where they are: "thol2016"
std::string add_references(std::vector<Quantity>& quantities, const Deck& deck, std::optional<double> density,
                           const std::filesystem::path& directory);

}  // namespace ljmd
