#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/fluid.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// The difference of two programs in one number, and its tolerance.
struct Check {
    std::string name;
    double value;
    double tolerance;

    /// False for NaN.
    [[nodiscard]] bool passed() const { return value <= tolerance; }
};

/// |a - b| / |b|, or |a| if b is 0.
[[nodiscard]] double relative_difference(double a, double b);

/// The larger of two distances; NaN if one of them is NaN.
[[nodiscard]] double larger_or_nan(double a, double b);

/// Kinetic energies are compared up to this step.
inline constexpr Index last_step_of_kinetic_energy = 100;

/// Properties of a comparison that determine its tolerances.
struct Situation {
    double temperature = 0.722;  ///< [epsilon/k_B]
    double time_step = 0.004;    ///< [tau]
    double longest_edge = 10.0;  ///< of the box [sigma]
    Index atoms = 864;
};
[[nodiscard]] Situation situation_of(const Fluid& fluid, double time_step);

/// Tolerances for two programs that compute the same. docs/crosscheck.md lists the measurements behind them.
struct Agreement {
    double energy;          ///< |U - U'| / |U'|
    double largest_force;   ///< max |F - F'| / F_rms
    double rms_force;       ///< rms of |F - F'| / F_rms
    double pressure;        ///< |p - p'| / ((2 K + |W|)/3V), which is the size of the terms of p
    double kinetic_energy;  ///< |K - K'| at equal times / max(K', K' at the start); infinite: no limit

    /// Limit of the largest distance between the two positions of an atom; ascending steps.
    struct Limit {
        Index step;
        double distance;  ///< [sigma]
    };
    std::vector<Limit> positions;
    /// The same for a method of the other program with the same operations in the same order.
    std::vector<Limit> positions_in_the_same_order;
};

/// Two programs in double precision. Distances begin at one unit in the last place of a coordinate and grow like
/// exp(lambda t), with lambda = 3.75/tau in a cold liquid. After a long time the largest distance also grows with the
/// number of atoms; at step 1000 it differs a thousandfold between starts, so step 500 has the last limit. A
/// separation is as inexact as the coordinates it is computed from, so all of them are less exact in large boxes.
/// Trajectories of a hot fluid (T > 1) diverge twice as fast and are compared only up to step 200.
[[nodiscard]] Agreement double_agreement(const Situation& situation);

/// LAMMPS, which sums in another order over other lists.
[[nodiscard]] Agreement lammps_agreement(const Situation& situation);

/// One of the two programs computes forces in single precision.
[[nodiscard]] Agreement single_agreement(const Situation& situation);

/// The limit at a step: of the first list entry at or after it; nothing beyond the list.
[[nodiscard]] std::optional<double> limit_at(const std::vector<Agreement::Limit>& limits, Index step);

/// Largest accepted difference of two means, in standard errors of the difference.
inline constexpr double max_sigmas = 3.0;

/// Largest difference between two g(r) of 300 independent configurations of 864 atoms each, in bins of 0.01 sigma.
inline constexpr double rdf_difference = 0.08;

}  // namespace ljmd
