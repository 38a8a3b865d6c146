#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/detail/reference/equation_of_state.hpp"

namespace ljmd {

/// How a property of a reference state is measured.
enum class MeasuredBy {
    averages,   ///< means of canonical runs
    responses,  ///< `response_functions` of canonical runs
    insertion,  ///< `chemical_potential` of canonical runs
    structure,  ///< a table of canonical runs: `rdf`, `structure_factor`
    transport   ///< runs at constant energy
};

/// A property that `ljmd reference` finds.
struct ReferenceProperty {
    const char* name;     ///< as in results.json; for `structure` the name of the analysis
    const char* alias;    ///< a short name for the command line
    MeasuredBy measured;  ///< how
    double
        default_error;  ///< relative statistical error that is reached where none is asked for; 0: it is not waited for
    std::optional<double> (*by_equation)(
        const FluidProperties&);  ///< the same by an equation of state; null: it has none
};

/// All of them, those that every reference has first: energy, pressure, compressibility factor.
[[nodiscard]] const std::vector<ReferenceProperty>& reference_properties();

/// The property with this name or alias. @throws InputError  there is none: lists them
[[nodiscard]] const ReferenceProperty& reference_property(const std::string& name);

/// The value by an equation of state; none for properties that an equation does not give.
[[nodiscard]] std::optional<double> value_by_equation(const ReferenceProperty& property, const FluidProperties& state);

}  // namespace ljmd
