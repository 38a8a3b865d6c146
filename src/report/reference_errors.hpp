#pragma once

#include <optional>

#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/reference/equation_of_state.hpp"

namespace ljmd {

// What is known of the errors that stand between a run and an equation of state, apart from statistics.

/// What pairs beyond the cutoff add to the tail correction, which takes g(r) = 1 there:
///
///     dU/N = 2 pi rho integral of (g - 1) phi r^2 dr      dp = -2 pi/3 rho^2 integral of (g - 1) phi' r^3 dr
///
/// over r from the cutoff to where g is known, with phi = 4 (r^-12 - r^-6).
struct BeyondCutoff {
    double energy;
    double pressure;
};

/// @param rdf  columns r (middles of equal bins) and g
/// @return empty if g is known over less than one sigma beyond the cutoff, or the table is another one
[[nodiscard]] std::optional<BeyondCutoff> beyond_cutoff(const DataTable& rdf, double cutoff, double density);

/// How far another equation of the same fluid lies from this one: the largest difference of those that hold at the
/// state; 0 if there is none. @param property  of FluidProperties
[[nodiscard]] double difference_of_equations(const EquationOfState& equation, double temperature, double density,
                                             double FluidProperties::*property);

}  // namespace ljmd
