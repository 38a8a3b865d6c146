#include "compare/point_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "ljmd/detail/potentials/tail_correction.hpp"

namespace ljmd {

namespace {

/// Forces below this are rounding errors of a vanishing sum.
constexpr double vanishing_force = 1e-9;

/// Tolerance between two closed forms.
constexpr double closed_form = 1e-10;
/// Tolerance if one side integrates numerically: OpenMM's custom forces do, until two estimates differ by 1e-5.
constexpr double numerical_tail = 1e-4;

double volume(const Fluid& fluid) {
    return fluid.edges.prod();
}

}  // namespace

PeerPoint point_of(const Fluid& fluid, ForceField& force_field, const Execution& execution) {
    State state = state_of(fluid, execution);
    const Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    PeerPoint point{{evaluation.potential_energy, kinetic_energy(fluid), evaluation.virial.trace()},
                    std::vector<Vec3>(fluid.positions.size())};
    const auto forces = static_cast<const State&>(state).forces();
    for (Index i = 0; i < state.count(); ++i) {
        point.forces[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])] = forces.col(i);
    }
    if (fluid.tail) {
        const TailCorrection tail(fluid.potential);
        const double density = static_cast<double>(state.count()) / volume(fluid);
        point.tail_energy = tail.energy(density);
        point.tail_pressure = tail.pressure(density);
    }
    return point;
}

double pressure(const Totals& totals, const Fluid& fluid) {
    return (2.0 * totals.kinetic_energy + totals.virial) / (3.0 * volume(fluid));
}

std::vector<Check> compare_points(const PeerPoint& ours, const PeerPoint& theirs, const Fluid& fluid,
                                  const Agreement& agreement) {
    double largest = 0.0;
    double squares = 0.0;
    double squares_of_theirs = 0.0;
    for (std::size_t i = 0; i < theirs.forces.size(); ++i) {
        const double difference = (ours.forces[i] - theirs.forces[i]).norm();
        largest = larger_or_nan(largest, difference);
        squares += difference * difference;
        squares_of_theirs += theirs.forces[i].squaredNorm();
    }
    const auto count = static_cast<double>(theirs.forces.size());
    const double rms = std::sqrt(squares_of_theirs / count);
    const double unit = rms > vanishing_force ? rms : 1.0;

    const double terms = (2.0 * theirs.totals.kinetic_energy + std::abs(theirs.totals.virial)) / (3.0 * volume(fluid));
    const double off = std::abs(pressure(ours.totals, fluid) - pressure(theirs.totals, fluid));
    std::vector<Check> checks{
        {"potential energy", relative_difference(ours.totals.potential_energy, theirs.totals.potential_energy),
         agreement.energy},
        {"largest force difference", largest / unit, agreement.largest_force},
        {"rms force difference", std::sqrt(squares / count) / unit, agreement.rms_force},
        {"pressure", terms > 0.0 ? off / terms : off, agreement.pressure}};
    const bool closed = fluid.potential.formula() == "lennard-jones";
    if (ours.tail_energy && theirs.tail_energy) {
        checks.push_back({"tail correction of the energy", relative_difference(*ours.tail_energy, *theirs.tail_energy),
                          closed ? closed_form : numerical_tail});
    }
    if (ours.tail_pressure && theirs.tail_pressure) {
        checks.push_back({"tail correction of the pressure",
                          relative_difference(*ours.tail_pressure, *theirs.tail_pressure),
                          closed ? closed_form : numerical_tail});
    }
    return checks;
}

}  // namespace ljmd
