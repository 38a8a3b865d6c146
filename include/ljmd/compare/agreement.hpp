#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/compare/fluid.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// One number that tells how far two programs are apart, and how far they may be.
struct Check {
    std::string name;
    double value;
    double tolerance;

    /// False when the value is not a number.
    [[nodiscard]] bool passed() const { return value <= tolerance; }
};

/// |a - b| / |b|, and |a| where b is 0.
[[nodiscard]] double relative_difference(double a, double b);

/// The larger of two distances; not a number if one of them is not.
[[nodiscard]] double larger_or_nan(double a, double b);

/// Kinetic energies are judged up to this step.
inline constexpr Index last_step_of_kinetic_energy = 100;

/// What tolerances depend on.
struct Situation {
    double temperature = 0.722;  ///< [epsilon/k_B]
    double time_step = 0.004;    ///< [tau]
    double longest_edge = 10.0;  ///< of the box [sigma]
    Index atoms = 864;
};
[[nodiscard]] Situation situation_of(const Fluid& fluid, double time_step);

/// How far two programs that do the same may be apart. docs/crosscheck.md tells what was measured.
struct Agreement {
    double energy;          ///< |U - U'| / |U'|
    double largest_force;   ///< max |F - F'| / F_rms
    double rms_force;       ///< rms of |F - F'| / F_rms
    double pressure;        ///< |p - p'| / ((2 K + |W|)/3V), the size of the terms that p is the sum of
    double kinetic_energy;  ///< |K - K'| at equal times over the larger of K' and K' at the start; infinite: no limit

    /// The largest distance between the two places of an atom, ascending.
    struct Limit {
        Index step;
        double distance;  ///< [sigma]
    };
    std::vector<Limit> positions;
    /// The same for a method of the other program that does the same in the same order.
    std::vector<Limit> positions_in_the_same_order;
};

/// Two programs in double precision. Distances begin as units of the last place of a coordinate and grow like
/// exp(lambda t), lambda = 3.75/tau in a cold liquid; that of the atom that is furthest off, after long, with the
/// number of atoms. A separation is as uncertain as the coordinates that it is the difference of, so in large boxes all
/// of them are. Trajectories of a hot fluid (T > 1) part twice as fast and are judged up to step 200 only.
[[nodiscard]] Agreement double_agreement(const Situation& situation);

/// LAMMPS, whose sums run in another order over other lists.
[[nodiscard]] Agreement lammps_agreement(const Situation& situation);

/// One of the two computes forces in single precision.
[[nodiscard]] Agreement single_agreement(const Situation& situation);

/// What a list of limits says of a step: that of the first step of the list not before it, beyond the list nothing.
[[nodiscard]] std::optional<double> limit_at(const std::vector<Agreement::Limit>& limits, Index step);

/// Difference of two means in units of what both are uncertain by, at most which they may differ.
inline constexpr double most_sigmas = 3.0;

/// Largest difference between two g(r) of 300 independent configurations of 864 atoms each, in bins of 0.01 sigma.
inline constexpr double rdf_difference = 0.08;

}  // namespace ljmd
