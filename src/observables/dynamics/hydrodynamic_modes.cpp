#include "observables/dynamics/hydrodynamic_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/LevenbergMarquardt>

#include "ljmd/core/errors.hpp"
#include "observables/transport/correlation_windows.hpp"

namespace ljmd {

namespace {

constexpr Index least_values = 8;
constexpr double round_off = 1e-12;   // of F(k, 0) = S(k) in a crystal, whose k is none of its own
constexpr double fastest = 10.0;      // radians from one value to the next: what oscillates faster is not seen at all
constexpr double least_heat = -0.1;   // where there is none noise may make it negative
constexpr double still_there = 0.02;  // of C_T at the largest time

void require_values(const Eigen::VectorXd& values) {
    if (values.size() < least_values) {
        throw ContractViolation(fmt::format("{} values of a correlation function have no fit", values.size()));
    }
}

/// Rates and the frequency are exponentials of the parameters, so that they stay positive.
SoundModes modes_of(const Eigen::VectorXd& parameters) {
    return {parameters[0], std::exp(parameters[1]), std::exp(parameters[2]), std::exp(parameters[3])};
}

/// Differences from the function, and their derivatives by central differences.
struct Differences : Eigen::DenseFunctor<double> {
    Differences(const Eigen::VectorXd& of, double apart)
        : DenseFunctor<double>(4, static_cast<int>(of.size())), wanted(of), spacing(apart) {}

    int operator()(const Eigen::VectorXd& parameters, Eigen::VectorXd& differences) const {
        const SoundModes modes = modes_of(parameters);
        for (Index lag = 0; lag < wanted.size(); ++lag) {
            differences[lag] = modes.correlation(static_cast<double>(lag) * spacing) - wanted[lag];
        }
        return differences.allFinite() ? 0 : -1;
    }

    int df(const Eigen::VectorXd& parameters, Eigen::MatrixXd& derivatives) const {
        constexpr double step = 1e-5;
        Eigen::VectorXd above(wanted.size());
        Eigen::VectorXd below(wanted.size());
        for (Index k = 0; k < parameters.size(); ++k) {
            Eigen::VectorXd moved = parameters;
            moved[k] += step;
            (*this)(moved, above);
            moved[k] -= 2.0 * step;
            (*this)(moved, below);
            derivatives.col(k) = (above - below) / (2.0 * step);
        }
        return derivatives.allFinite() ? 0 : -1;
    }

    Eigen::VectorXd wanted;
    double spacing;
};

/// Whether the spectrum rises again on the way from w = 0.
bool has_side_peak(const SoundModes& modes) {
    constexpr int steps = 200;
    const double last = modes.frequency + modes.damping;
    double before = modes.spectrum(0.0);
    for (int n = 1; n <= steps; ++n) {
        const double here = modes.spectrum(last * n / steps);
        if (here > before) {
            return true;
        }
        before = here;
    }
    return false;
}

double sine_part(const SoundModes& modes) {
    return (modes.heat * modes.heat_rate + (1.0 - modes.heat) * modes.damping) / modes.frequency;  // (1 - A) b
}

}  // namespace

double SoundModes::correlation(double time) const {
    return heat * std::exp(-heat_rate * time) +
           std::exp(-damping * time) *
               ((1.0 - heat) * std::cos(frequency * time) + sine_part(*this) * std::sin(frequency * time));
}

double SoundModes::spectrum(double angular_frequency) const {
    const double below = angular_frequency - frequency;
    const double above = angular_frequency + frequency;
    const double near = damping * damping + below * below;
    const double far = damping * damping + above * above;
    const double central = heat * heat_rate / (angular_frequency * angular_frequency + heat_rate * heat_rate);
    const double cosine = 0.5 * (1.0 - heat) * (damping / near + damping / far);
    const double sine = 0.5 * sine_part(*this) * (above / far - below / near);
    return (central + cosine + sine) / std::numbers::pi;
}

std::optional<SoundModes> fitted_sound(const Eigen::VectorXd& correlation, double spacing, double first) {
    require_values(correlation);
    if (!(correlation[0] > round_off) || !(first > 0.0) || !(first * spacing < fastest)) {
        return std::nullopt;
    }
    Differences differences(correlation / correlation[0], spacing);
    Eigen::LevenbergMarquardt<Differences> search(differences);
    search.setMaxfev(400);
    // As in a dense liquid: a third of the intensity is heat, and the isothermal frequency is a fifth too low.
    Eigen::VectorXd parameters(4);
    parameters << 0.3, std::log(0.3 * first), std::log(0.3 * first), std::log(1.2 * first);
    search.minimize(parameters);
    const SoundModes modes = modes_of(parameters);
    const bool is_one = parameters.allFinite() && modes.heat > least_heat && modes.heat < 1.0;
    return is_one && has_side_peak(modes) ? std::optional(modes) : std::nullopt;
}

std::optional<double> transverse_viscosity(const Eigen::VectorXd& current, double spacing, double k, double density) {
    require_values(current);
    const Eigen::VectorXd normalized = current / current[0];
    const double rest = normalized.tail(std::max(normalized.size() / 10, Index{1})).mean();
    const double integral = running_integral(normalized, spacing)[normalized.size() - 1];
    if (!(std::abs(rest) < still_there) || !(integral > 0.0)) {
        return std::nullopt;
    }
    return density / (k * k * integral);
}

}  // namespace ljmd
