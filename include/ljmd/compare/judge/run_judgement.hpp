#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ljmd/compare/agreement.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// Samples of a run, of the whole system, tail corrections included. A missing quantity is empty.
struct RunSamples {
    std::vector<double> potential_energy;  ///< [epsilon]
    std::vector<double> kinetic_energy;    ///< [epsilon]
    std::vector<double> pressure;          ///< (2 K + W)/(3 V) + p_tail [epsilon/sigma^3]
    std::vector<double> volume;            ///< [sigma^3]
};

/// What is sampled.
struct RunConditions {
    Index atoms;
    double time_step;                     ///< [tau]
    std::optional<double> temperature{};  ///< that a thermostat holds; none: constant energy
    std::optional<double> pressure{};     ///< that a barostat holds
    Index freedom;                        ///< degrees of freedom of the engine's kinetic energy, see freedom_of()
    Index our_freedom;                    ///< of ljmd's
};

/// A mean of both programs.
struct ComparedMean {
    std::string name;
    Estimate ours;
    Estimate theirs;
    [[nodiscard]] double sigmas() const;  ///< |difference| over its standard error
};

/// The judgement of a run by the distributions of what it has sampled.
struct RunJudgement {
    std::vector<ComparedMean> means;
    std::vector<Check> checks;
    std::vector<std::string> diagnoses;
    std::vector<std::string> not_judged;  ///< what could not be judged, and why
};

/// Largest distance of the distribution of x from a gamma distribution of this shape and the mean of x, times the root
/// of the number of independent samples (Kolmogorov and Smirnov). Correlated samples are thinned by their statistical
/// inefficiency before.
/// @param inefficiency  number of samples that are worth an independent one, at least 1
[[nodiscard]] double gamma_distance(const std::vector<double>& x, double shape, double inefficiency);

/// Judge a run by its averages, against a run of ljmd under the same conditions, and by its distributions:
///
///     all          means of T, U/N, p (and V, H/N at constant pressure): at most 3 standard errors apart
///     canonical    K is gamma distributed with shape f/2 and scale T: its mean f T/2 and its variance f T^2/2 within 4
///                  standard errors, and the distance of Kolmogorov and Smirnov below 1.95, which is exceeded once in a
///                  thousand times. The mean may differ by what a time step does to K, 0.1 % at 0.004 tau
///     isobaric     the variances of V and of H: at most 4 standard errors of their logarithms apart
///
/// Standard errors are from block averages, so that correlations count. Series that are too short for them are not
/// judged. Sources: Shirts (2013), doi:10.1021/ct300688p, on ensembles as tests; for the errors see
/// BlockingAccumulator.
[[nodiscard]] RunJudgement judge_run(const RunConditions& conditions, const RunSamples& ours, const RunSamples& theirs);

}  // namespace ljmd
