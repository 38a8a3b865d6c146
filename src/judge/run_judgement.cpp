#include "judge/run_judgement.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/gsl_errors.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

constexpr double max_gamma_distance = 2.23;  // 2 exp(-2 x^2) = 1e-4: exceeded once in checks_for_a_false_alarm

/// What a time step does to the mean kinetic energy of velocity Verlet, relative, in a dense liquid at 0.004 tau. It
/// grows like the square of the time step.
constexpr double time_step_effect = 1e-3;
constexpr double usual_time_step = 0.004;

/// Of a mean of the engine at constant energy, over ljmd's.
constexpr double largest_ratio_of_errors = 1.5;

/// By which the total energy may fluctuate more from row to row than ljmd's, for whatever reason.
constexpr double more_spread = 1.1;

Estimate estimate_of(const std::vector<double>& series) {
    BlockingAccumulator blocks(1, Covariance::diagonal);
    for (const double x : series) {
        blocks.add(Eigen::VectorXd::Constant(1, x));
    }
    return blocks.estimate(0);
}

double mean_of(const std::vector<double>& series) {
    return std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(series.size());
}

/// The variance of a correlated series with its standard error.
Estimate variance_of(const std::vector<double>& series) {
    const double mean = mean_of(series);
    std::vector<double> squares;
    squares.reserve(series.size());
    for (const double x : series) {
        squares.push_back((x - mean) * (x - mean));
    }
    return estimate_of(squares);
}

/// a x + b y + c z, of the series that are there.
std::vector<double> sum_of(const std::vector<double>& x, const std::vector<double>& y, double c,
                           const std::vector<double>& z) {
    std::vector<double> sums;
    sums.reserve(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        sums.push_back(x[k] + y[k] + c * z[k]);
    }
    return sums;
}

std::vector<double> total_energy(const RunSamples& of) {
    return sum_of(of.potential_energy, of.kinetic_energy, 0.0, of.kinetic_energy);
}

std::vector<double> scaled(std::vector<double> series, double factor) {
    for (double& x : series) {
        x *= factor;
    }
    return series;
}

Variance variance_of_mean(const Estimate& estimate) {
    return {estimate.standard_error * estimate.standard_error,
            std::max(1.0, static_cast<double>(estimate.blocks > 0 ? estimate.blocks : estimate.samples) - 1.0)};
}

Variance times(const Variance& variance, double factor) {
    return {factor * variance.value, variance.freedom};
}

/// x without what the energy makes of it: x - dX/dE (E - <E>), with the same mean.
std::vector<double> without_walk(std::vector<double> x, double slope, const std::vector<double>& energy, double mean) {
    for (std::size_t k = 0; k < x.size(); ++k) {
        x[k] -= slope * (energy[k] - mean);
    }
    return x;
}

/// Collects a judgement.
class Judge {
  public:
    Judge(const RunConditions& conditions, const RunSamples& ours, const RunSamples& theirs)
        : conditions_(conditions), ours_(ours), theirs_(theirs) {}

    RunJudgement judge() {
        const auto atoms = static_cast<double>(conditions_.atoms);
        const double freedom = std::max(1.0, static_cast<double>(conditions_.freedom));
        const double our_freedom = std::max(1.0, static_cast<double>(conditions_.our_freedom));
        const double temperature = 2.0 * mean_of(ours_.kinetic_energy) / our_freedom;
        const double volume = mean_of(ours_.volume);
        const double effect = conditions_.same_motion ? 0.0 : conditions_.step_effect() * temperature;
        if (conditions_.same_motion && std::ssize(ours_.kinetic_energy) >= rows_of_a_walk) {
            our_energy_ = total_energy(ours_);
            walk_ = energy_walk(our_energy_);
        }
        compare_means("temperature", scaled(ours_.kinetic_energy, 2.0 / our_freedom),
                      scaled(theirs_.kinetic_energy, 2.0 / freedom), 2.0 / our_freedom, effect);
        compare_means("potential_energy", scaled(ours_.potential_energy, 1.0 / atoms),
                      scaled(theirs_.potential_energy, 1.0 / atoms), 0.0, 1.5 * effect);
        if (conditions_.freedom == conditions_.our_freedom) {
            // A virial changes by some twelve times the energy of pairs that repel each other.
            compare_means("pressure", ours_.pressure, theirs_.pressure, 2.0 / (3.0 * volume),
                          6.0 * effect * atoms / volume);
        } else {
            leave_out("mean pressure", "the engine's kinetic energy has other degrees of freedom");
        }
        if (conditions_.same_motion && conditions_.same_precision) {
            judge_total_energy();
        } else if (!conditions_.temperature && !conditions_.pressure) {
            leave_out("total energy", "it has another error with another integrator or precision");
        }
        if (conditions_.temperature) {
            judge_kinetic_energy();
        }
        if (conditions_.pressure) {
            compare_means("volume", ours_.volume, theirs_.volume, 0.0, conditions_.step_effect() * volume);
            compare_variances("volume", ours_.volume, theirs_.volume);
            const bool all =
                !theirs_.volume.empty() && !theirs_.potential_energy.empty() && !theirs_.kinetic_energy.empty();
            const auto enthalpy = [&](const RunSamples& of) {
                return all ? sum_of(of.potential_energy, of.kinetic_energy, *conditions_.pressure, of.volume)
                           : std::vector<double>{};
            };
            compare_means("enthalpy", scaled(enthalpy(ours_), 1.0 / atoms), scaled(enthalpy(theirs_), 1.0 / atoms), 0.0,
                          3.0 * effect + conditions_.step_effect() * *conditions_.pressure * volume / atoms);
            compare_variances("enthalpy", enthalpy(ours_), enthalpy(theirs_));
        }
        return std::move(result_);
    }

  private:
    void leave_out(const std::string& what, const std::string& why) {
        result_.not_judged.push_back(fmt::format("{}: {}", what, why));
    }

    /// Whether errors of both series are known; else says so.
    bool are_known(const std::string& name, const Estimate& ours, const Estimate& theirs) {
        for (const auto& [whose, estimate] : {std::pair("of ljmd", &ours), std::pair("of the engine", &theirs)}) {
            if (!estimate->converged || !std::isfinite(estimate->standard_error)) {
                leave_out(
                    name,
                    fmt::format("the run {} is too short, {} samples of it are worth {:.0f} independent ones", whose,
                                estimate->samples,
                                std::isfinite(estimate->independent_samples) ? estimate->independent_samples : 0.0));
                return false;
            }
        }
        return true;
    }

    /// @param kinetic_part  a of X = a K + B, see change_with_energy()
    /// @param allowed       what a time step may do to the mean
    void compare_means(const std::string& name, const std::vector<double>& ours, const std::vector<double>& theirs,
                       double kinetic_part, double allowed) {
        if (theirs.empty() || ours.empty()) {
            leave_out("mean " + name, "thermo.csv has no such column");
            return;
        }
        ComparedMean mean{name, estimate_of(ours), estimate_of(theirs), 0.0, allowed};
        std::vector<Variance> parts;
        if (walk_) {
            const double slope = change_with_energy(ours, kinetic_part, ours_.kinetic_energy,
                                                    static_cast<double>(conditions_.our_freedom));
            mean.ours = estimate_of(without_walk(ours, slope, our_energy_, walk_->mean));
            parts.push_back(times(walk_->walk, 2.0 * slope * slope));
            const double most = largest_ratio_of_errors * mean.ours.standard_error;
            if (!mean.theirs.converged || !(mean.theirs.standard_error <= most)) {
                mean.theirs.standard_error = most;
                mean.theirs.blocks = mean.ours.blocks;
                mean.theirs.converged = mean.ours.converged;
            }
        }
        if (!are_known("mean " + name, mean.ours, mean.theirs)) {
            return;
        }
        parts.push_back(variance_of_mean(mean.ours));
        parts.push_back(variance_of_mean(mean.theirs));
        for (const Variance& part : parts) {
            mean.error = std::hypot(mean.error, std::sqrt(part.value));
        }
        result_.means.push_back(mean);
        result_.checks.push_back({"mean " + name + ", standard errors apart", mean.sigmas(), limit_of_errors(parts)});
    }

    /// Where energy is conserved: its mean, drift and spread, by the errors of ljmd's run alone.
    void judge_total_energy() {
        if (theirs_.potential_energy.empty() || theirs_.kinetic_energy.empty()) {
            leave_out("total energy", "thermo.csv has not both potential and kinetic energy");
            return;
        }
        if (!walk_ || std::ssize(theirs_.kinetic_energy) < rows_of_a_walk) {
            leave_out("total energy", fmt::format("there are fewer than {} rows", rows_of_a_walk));
            return;
        }
        const EnergyWalk theirs = energy_walk(total_energy(theirs_));
        const double digits =
            conditions_.digits * (std::abs(mean_of(ours_.potential_energy)) + mean_of(ours_.kinetic_energy));
        const auto apart = [&](const char* what, double difference, double of_noise, double of_walk) {
            const std::vector<Variance> parts{times(walk_->of_mean, 2.0 * of_noise), times(walk_->walk, 2.0 * of_walk)};
            const double error = std::sqrt(parts[0].value + parts[1].value + digits * digits);
            result_.checks.push_back({fmt::format("{} of the total energy, standard errors apart", what),
                                      std::abs(difference) / error, limit_of_errors(parts)});
        };
        apart("mean", theirs.mean - walk_->mean, 1.0, 1.0);
        // The slope of a straight line, over the whole run, has 12 times the variance of the mean by noise, and 3.6
        // times by a walk.
        apart("drift", theirs.slope - walk_->slope, 12.0, 3.6);
        const double error = std::sqrt(2.0) * walk_->jitter_error;
        result_.checks.push_back({"spread of the total energy from row to row, over that of ljmd",
                                  theirs.jitter / std::hypot(walk_->jitter, digits),
                                  more_spread * std::exp(error * limit_of_errors({{1.0, 15.0}}))});
    }

    void compare_variances(const std::string& name, const std::vector<double>& ours,
                           const std::vector<double>& theirs) {
        if (theirs.empty()) {
            return;  // the mean has said so
        }
        const Estimate our_variance = variance_of(ours);
        const Estimate their_variance = variance_of(theirs);
        if (!are_known("variance of " + name, our_variance, their_variance)) {
            return;
        }
        const double error = std::hypot(our_variance.standard_error / our_variance.mean,
                                        their_variance.standard_error / their_variance.mean);
        const double ratio = their_variance.mean / our_variance.mean;
        const double sigmas = std::abs(std::log(ratio)) / error;
        const double limit =
            limit_of_errors({times(variance_of_mean(our_variance), 1.0 / std::pow(our_variance.mean, 2)),
                             times(variance_of_mean(their_variance), 1.0 / std::pow(their_variance.mean, 2))});
        result_.checks.push_back({"variance of " + name + ", standard errors apart",
                                  std::isnan(sigmas) ? std::numeric_limits<double>::infinity() : sigmas, limit});
        if (!(sigmas <= limit) && ratio < 1.0) {
            result_.diagnoses.push_back(
                fmt::format("too little fluctuation: the variance of the {} is {:.2g} of that at constant pressure and "
                            "temperature: "
                            "a barostat like that of Berendsen",
                            name, ratio));
        }
    }

    /// Whether U + K of the engine is as good as constant beside K: at constant temperature it fluctuates more than K.
    [[nodiscard]] bool conserves_energy() const {
        constexpr double hardly = 0.1;
        if (theirs_.potential_energy.size() != theirs_.kinetic_energy.size()) {
            return false;
        }
        return variance_of(total_energy(theirs_)).mean < hardly * hardly * variance_of(theirs_.kinetic_energy).mean;
    }

    void judge_kinetic_energy() {
        const std::vector<double>& k = theirs_.kinetic_energy;
        if (k.empty()) {
            leave_out("distribution of the kinetic energy", "thermo.csv has neither kinetic_energy nor temperature");
            return;
        }
        const auto freedom = static_cast<double>(conditions_.freedom);
        const double temperature = *conditions_.temperature;
        const Estimate mean = estimate_of(k);
        const Estimate variance = variance_of(k);
        if (!are_known("distribution of the kinetic energy", mean, mean) ||
            !are_known("variance of the kinetic energy", variance, variance)) {
            return;
        }
        const double expected = 0.5 * freedom * temperature;
        const double allowed = conditions_.step_effect() * expected;
        const double limit = limit_of_errors({variance_of_mean(mean)});
        const double limit_of_variance = limit_of_errors({variance_of_mean(variance)});
        const auto sigmas_from = [&](double value) {
            const double off = std::max(0.0, std::abs(mean.mean - value) - allowed);
            return off == 0.0 ? 0.0 : off / mean.standard_error;
        };
        const double off = sigmas_from(expected);
        result_.checks.push_back({"mean kinetic energy from f T/2, standard errors", off, limit});
        const double ratio = variance.mean / (0.5 * freedom * temperature * temperature);
        const double off_variance = std::abs(ratio - 1.0) * variance.mean / ratio / variance.standard_error;
        result_.checks.push_back({"variance of the kinetic energy from f T^2/2, standard errors",
                                  std::isnan(off_variance) ? std::numeric_limits<double>::infinity() : off_variance,
                                  limit_of_variance});
        const double inefficiency = static_cast<double>(mean.samples) / mean.independent_samples;
        result_.checks.push_back({"distribution of the kinetic energy from gamma(f/2), Kolmogorov and Smirnov",
                                  gamma_distance(k, 0.5 * freedom, inefficiency), max_gamma_distance});
        if ((!(off <= limit) || !(off_variance <= limit_of_variance)) && conserves_energy()) {
            result_.diagnoses.push_back(fmt::format(
                "no thermostat: the total energy is conserved, where the deck holds the temperature at {:g}",
                temperature));
            return;
        }
        if (!(off <= limit)) {
            const Index others = conditions_.freedom == 3 * conditions_.atoms ? degrees_of_freedom(conditions_.atoms)
                                                                              : 3 * conditions_.atoms;
            const double all = 0.5 * static_cast<double>(others) * temperature;
            result_.diagnoses.push_back(
                sigmas_from(all) < max_sigmas
                    ? fmt::format(
                          "3N against 3N-3: the mean kinetic energy is {0} T/2, not {1:g} T/2: the thermostat counts "
                          "other degrees of freedom. There are 3 N if it acts on the centre of mass, else 3 N - 3; if "
                          "{0} are right, state degrees_of_freedom = {0} in point.json",
                          others, freedom)
                    : fmt::format("other temperature: the mean kinetic energy is that of T = {:.5g}, where it is {:g}",
                                  2.0 * mean.mean / freedom, temperature));
        }
        if (!(off_variance <= limit_of_variance) && ratio < 1.0) {
            result_.diagnoses.push_back(
                fmt::format("too little fluctuation: the variance of the kinetic energy is {:.2g} of the canonical f "
                            "T^2/2: a thermostat "
                            "that rescales velocities, or like that of Berendsen",
                            ratio));
        }
    }

    const RunConditions& conditions_;
    const RunSamples& ours_;
    const RunSamples& theirs_;
    std::vector<double> our_energy_;    ///< U + K, where there is a walk
    std::optional<EnergyWalk> walk_{};  ///< of ljmd's run at constant energy
    RunJudgement result_;
};

}  // namespace

double ComparedMean::sigmas() const {
    const double difference = std::max(0.0, std::abs(ours.mean - theirs.mean) - allowed);
    return difference == 0.0 ? 0.0 : difference / error;
}

double RunConditions::step_effect() const {
    const double step = time_step / usual_time_step;
    return std::max(time_step_effect * step * step, squared_frequency * time_step * time_step / 3.0);
}

double limit_of_errors(const std::vector<Variance>& variances) {
    double sum = 0.0;
    double squares = 0.0;
    for (const Variance& variance : variances) {
        sum += variance.value;
        squares += variance.value * variance.value / variance.freedom;
    }
    constexpr double most = 1e6;  // as good as exact
    const double freedom = squares > 0.0 ? std::min(most, sum * sum / squares) : most;
    const GslErrorCodes codes;
    return gsl_cdf_tdist_Qinv(0.5 / checks_for_a_false_alarm, freedom);
}

double gamma_distance(const std::vector<double>& x, double shape, double inefficiency) {
    const double scale = mean_of(x) / shape;
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(inefficiency)));
    std::vector<double> sorted;
    for (std::size_t k = 0; k < x.size(); k += stride) {
        sorted.push_back(x[k]);
    }
    std::ranges::sort(sorted);
    const auto n = static_cast<double>(sorted.size());
    double largest = 0.0;
    const GslErrorCodes codes;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const double f = gsl_cdf_gamma_P(sorted[k], shape, scale);
        const auto below = static_cast<double>(k);
        largest = std::max({largest, f - below / n, (below + 1.0) / n - f});
    }
    return largest * std::sqrt(n);
}

RunJudgement judge_run(const RunConditions& conditions, const RunSamples& ours, const RunSamples& theirs) {
    return Judge(conditions, ours, theirs).judge();
}

}  // namespace ljmd
