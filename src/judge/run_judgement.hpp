#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/agreement.hpp"
#include "judge/energy_walk.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// Samples of a run at equal intervals, of the whole system, tail corrections included. A missing quantity is empty.
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
    double squared_frequency = 0.0;       ///< sum of F^2/(3 N T): mean square of the frequencies of the atoms [1/tau^2]
    bool same_precision = true;           ///< of both; a walk by rounding is larger in single precision
    bool same_motion = false;             ///< constant energy, and the method of both is velocity Verlet
    double digits = 1e-9;                 ///< relative differences that are none because numbers have been through text

    /// What a time step does to the mean kinetic energy of a right program, relative. Velocities of velocity Verlet at
    /// temperature T have <v^2> = T/(1 + w^2 dt^2/6), other methods other errors of this order; twice that is allowed,
    /// at least 0.1 % (dt/0.004)^2, which is enough in a dense liquid.
    [[nodiscard]] double step_effect() const;
};

/// A mean of both programs.
struct ComparedMean {
    std::string name;
    Estimate ours;
    Estimate theirs;
    double error;                         ///< standard error of the difference
    double allowed = 0.0;                 ///< difference that is none, because methods have errors of the time step
    [[nodiscard]] double sigmas() const;  ///< |difference| beyond what is allowed, over its standard error
};

/// A right run fails a check of averages by chance once in so many times.
inline constexpr double checks_for_a_false_alarm = 1e4;

/// So many standard errors a right number is off once in checks_for_a_false_alarm times, if its variance is a sum of
/// estimates: Student's t, with the degrees of freedom of the sum by Welch and Satterthwaite. 3.9 where errors are
/// exact, 4.5 with 30 degrees of freedom, 5.7 with 12.
[[nodiscard]] double limit_of_errors(const std::vector<Variance>& variances);

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
///     all          means of T, U/N, p (and V, H/N at constant pressure)
///     constant E   mean of U + K, its drift (slope of a straight line), and its spread from row to row
///     canonical    K is gamma distributed with shape f/2 and scale T: its mean f T/2 and its variance f T^2/2, and the
///                  distance of Kolmogorov and Smirnov below 2.23
///     isobaric     the variances of V and of H, by their logarithms
///
/// Each is off by no more standard errors than limit_of_errors() says. Standard errors are from block averages, so that
/// correlations count. Series that are too short for them are not judged.
///
/// At constant energy, with the same motion, the energy of two right programs walks in two ways (EnergyWalk), so that a
/// mean X has the further variance 2 dE^2 (dX/dE)^2, with dE and dX/dE of ljmd's run alone. The errors of the engine's
/// energy are taken from ljmd's run, and those of its other means are no more than one and a half times ljmd's: an
/// engine that drifts does not widen its own limits. Elsewhere means may differ by what a time step does to them.
/// Sources: Shirts (2013), doi:10.1021/ct300688p, on ensembles as tests; for the errors see BlockingAccumulator.
[[nodiscard]] RunJudgement judge_run(const RunConditions& conditions, const RunSamples& ours, const RunSamples& theirs);

}  // namespace ljmd
