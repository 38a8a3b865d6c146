#pragma once

#include <string>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// A standard error that a run is to reach.
struct WantedError {
    std::string observable;  ///< its name in results.json
    double error;            ///< one standard deviation of its mean, reduced; above 0

    friend bool operator==(const WantedError&, const WantedError&) = default;
};

/// A wanted error and the present one.
struct ErrorSoFar {
    WantedError wanted;
    double error;        ///< see stopped_estimate(); NaN if there is none
    double independent;  ///< independent samples; NaN if the error is
    bool reached;        ///< see is_reached()
};

/// The estimate for a series whose length its own error decides: the standard error of block averages, enlarged to
///
///     e' = e (1 + 2/nu),   nu = blocks - 1
///
/// e is known to 1/sqrt(2 nu). Student's distribution with nu degrees of freedom asks for 1 + 1/(2 nu), so that the
/// mean +- one error covers the truth in 68 %. The rest is what stopping costs: of the errors at a look those that are
/// too small end the series, and those that are too large go on. The 2 was found by measurement: over white and
/// correlated series and all errors wanted, 66.6 to 70 % of the intervals cover the truth with it, 62 to 67 % without
/// (docs/averages.md).
[[nodiscard]] Estimate stopped_estimate(Estimate estimate);

/// Whether a length can be ended with this estimate: the error is at most the wanted one, it comes from at least 150
/// independent samples, and it is no guess. @param estimate  of stopped_estimate()
[[nodiscard]] bool is_reached(const Estimate& estimate, double wanted);

/// Whether errors are looked at after so many samples: after 128, 182, 256, 363, ..., each sqrt(2) times the one
/// before, rounded up. Whoever looks after every sample and stops at the first error that is small enough stops where
/// it is small by chance.
[[nodiscard]] bool is_look(Index samples);

inline constexpr Index first_look = 128;                  ///< [samples]
inline constexpr double least_independent_samples = 150;  ///< of a length that can be ended

}  // namespace ljmd
