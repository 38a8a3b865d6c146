#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// How far two programs that do the same may be apart. docs/crosscheck.md tells what was measured.
struct Agreement {
    double energy;          ///< |U - U'| / |U'|, and the same of the kinetic energy at the same time up to step 100
    double largest_force;   ///< max |F - F'| / F_rms
    double rms_force;       ///< rms of |F - F'| / F_rms
    double pressure;        ///< |p - p'| / ((2 K + |W|)/3V), the size of the terms that p is the sum of
    double kinetic_energy;  ///< |K - K'| / K' at equal times, up to step 100

    /// The largest distance between the two places of an atom, ascending; for time steps of up to 0.004 tau, see
    /// limit_at.
    struct Limit {
        Index step;
        double distance;  ///< [sigma]
    };
    std::vector<Limit> positions;
    /// The same for a method of the other program that does the same in the same order.
    std::vector<Limit> positions_in_the_same_order;
};

/// Two programs in double precision. Trajectories of a hot fluid part faster and are judged up to step 200 only.
[[nodiscard]] Agreement double_agreement(double temperature);

/// LAMMPS, whose sums run in another order over other lists.
[[nodiscard]] Agreement lammps_agreement();

/// One of the two computes forces in single precision.
[[nodiscard]] Agreement single_agreement();

/// What a list of limits says of a step: that of the first step of the list not before it, beyond the list nothing.
/// With longer time steps the same step is later, and distances have grown by exp(3.75 t/tau) in the additional time.
[[nodiscard]] std::optional<double> limit_at(const std::vector<Agreement::Limit>& limits, Index step, double time_step);

/// Difference of two means in units of what both are uncertain by, at most which they may differ.
inline constexpr double most_sigmas = 3.0;

/// Largest difference between two g(r) of 300 independent configurations of 864 atoms each, in bins of 0.01 sigma.
inline constexpr double rdf_difference = 0.08;

}  // namespace ljmd
