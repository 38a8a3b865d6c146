#include "observables/structure/coordination_number.hpp"
#include "observables/statistics/known_quantities.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ljmd {

namespace {

constexpr double widest_shell = 0.04;   // [sigma]
constexpr double farthest_shell = 3.2;  // [sigma]: beyond the second peak; larger covariances would fill checkpoints
constexpr double half_window = 0.25;    // [sigma], of the fit
constexpr double smoothing = 0.1;       // [sigma] to each side, in the search for the lowest shell
constexpr double significance = 5.0;    // standard errors: one of many noise peaks reaches 3
constexpr double largest_place_error = 0.05;  // [sigma]: farther away the fit is a different one
constexpr double sphere = 4.0 * std::numbers::pi;

/// Coefficients of a cubic in x = r - centre, as a linear function of the numbers in the shells.
using Cubic = Eigen::Matrix<double, 4, Eigen::Dynamic>;

Eigen::Vector4d powers(double x) {
    return {1.0, x, x * x, x * x * x};
}

/// 4 pi integral of r^2 (1, x, x^2, x^3) dr by Gauss's rule with three points, which is exact to the fifth degree.
Eigen::Vector4d integral_of_powers(double from, double to, double centre) {
    constexpr std::array<double, 3> weights{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    const double offset = 0.5 * std::sqrt(0.6) * (to - from);
    const double middle = 0.5 * (from + to);
    const std::array<double, 3> points{middle - offset, middle, middle + offset};
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (std::size_t p = 0; p < points.size(); ++p) {
        sum += (to - from) * weights[p] * sphere * points[p] * points[p] * powers(points[p] - centre);
    }
    return sum;
}

/// Fitted density around an atom.
class Profile {
  public:
    Profile(const Eigen::VectorXd& numbers, double width) : numbers_(numbers), width_(width) {}

    [[nodiscard]] Index shells() const { return numbers_.size(); }
    [[nodiscard]] double middle(Index shell) const { return width_ * (static_cast<double>(shell) + 0.5); }
    [[nodiscard]] Index shell_of(double r) const { return static_cast<Index>(r / width_); }
    [[nodiscard]] double end() const { return width_ * static_cast<double>(shells()); }
    [[nodiscard]] double density(Index shell) const { return numbers_[shell] / volumes(shell, 0.0)[0]; }

    [[nodiscard]] Cubic cubic(double centre) const;
    [[nodiscard]] Eigen::Vector4d fitted(double centre) const { return cubic(centre) * numbers_; }
    [[nodiscard]] double slope(double r) const { return fitted(r)[1]; }

    /// Midpoint of the interval next to r in which the slope is zero; none if it does not change from falling to rising
    /// within half_window.
    [[nodiscard]] std::optional<double> minimum_near(double r) const;

  private:
    [[nodiscard]] Eigen::Vector4d volumes(Index shell, double centre) const {
        const double begin = width_ * static_cast<double>(shell);
        return integral_of_powers(begin, begin + width_, centre);
    }

    const Eigen::VectorXd& numbers_;
    double width_;
};

Cubic Profile::cubic(double centre) const {
    Cubic right = Cubic::Zero(4, shells());
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    for (Index k = 0; k < shells(); ++k) {
        const double distance = (middle(k) - centre) / half_window;
        const double weight = 1.0 - distance * distance;
        if (weight > 0.0) {
            const Eigen::Vector4d moments = volumes(k, centre);
            // Divided by the volume, because the mean density of a shell is fitted by the mean of the cubic.
            right.col(k) = weight / (moments[0] * moments[0]) * moments;
            normal += right.col(k) * moments.transpose();
        }
    }
    return normal.ldlt().solve(right);
}

std::optional<double> Profile::minimum_near(double r) const {
    constexpr double step = 0.01;
    double low = r;
    double high = r;
    while (low > r - half_window && !(slope(low) < 0.0)) {
        low -= step;
    }
    while (high < r + half_window && !(slope(high) > 0.0)) {
        high += step;
    }
    if (!(slope(low) < 0.0 && slope(high) > 0.0)) {
        return std::nullopt;
    }
    // The density between shells of a cold crystal is zero, and so is the slope in a whole interval.
    const auto border = [&](auto is_before) {
        double before = low;
        double behind = high;
        for (int n = 0; n < 50; ++n) {
            const double between = 0.5 * (before + behind);
            (is_before(slope(between)) ? before : behind) = between;
        }
        return before;
    };
    return 0.5 * (border([](double s) { return s < 0.0; }) + border([](double s) { return s <= 0.0; }));
}

/// The lowest shell, smoothed, between the highest one and twice its distance; none if the shells end too early.
std::optional<Index> lowest_shell(const Profile& profile) {
    Eigen::VectorXd density(profile.shells());
    for (Index k = 0; k < density.size(); ++k) {
        density[k] = profile.density(k);
    }
    Index peak = 0;
    const double highest = density.maxCoeff(&peak);
    const Index reach = profile.shell_of(smoothing);
    const Index last = std::min(2 * peak + 1, density.size() - 1 - reach);
    if (!(highest > 0.0) || peak < reach) {
        return std::nullopt;
    }
    Index lowest = peak;
    double least = highest;
    for (Index k = peak + 1; k <= last; ++k) {
        const double smooth = density.segment(k - reach, 2 * reach + 1).mean();
        if (smooth < least) {
            least = smooth;
            lowest = k;
        }
    }
    return lowest;
}

}  // namespace

CoordinationNumber::Division CoordinationNumber::division(Index bins, double radius) {
    constexpr double rounding =
        1e-9;  // two bins of 0.02 make a shell of 0.04, though they are a little more in doubles
    const double bin = radius / static_cast<double>(bins);
    const auto parts = std::max(static_cast<Index>(std::ceil(bin / widest_shell - rounding)), Index{1});
    const double part = bin / static_cast<double>(parts);
    const auto in_a_shell = std::max(static_cast<Index>(widest_shell / part + rounding), Index{1});
    const double width = static_cast<double>(in_a_shell) * part;
    const auto max_shells = std::max(static_cast<Index>(farthest_shell / width + rounding), Index{1});
    return {parts, in_a_shell, std::min(parts * bins / in_a_shell, max_shells), width};
}

CoordinationNumber::CoordinationNumber(const Division& division)
    : division_(division), shells_(division.shells, Covariance::full) {}

void CoordinationNumber::add(const std::vector<Index>& counts, Index atoms) {
    Eigen::VectorXd numbers = Eigen::VectorXd::Zero(division_.shells);
    for (Index part = 0; part < division_.shells * division_.in_a_shell; ++part) {
        numbers[part / division_.in_a_shell] +=
            2.0 * static_cast<double>(counts[static_cast<std::size_t>(part)]) / static_cast<double>(atoms);
    }
    shells_.add(numbers);
}

std::optional<Estimate> CoordinationNumber::estimate() const {
    const Eigen::VectorXd numbers = shells_.mean();
    const Profile profile(numbers, division_.width);
    const std::optional<Index> lowest = lowest_shell(profile);
    if (!lowest) {
        return std::nullopt;
    }
    const double around = profile.middle(*lowest);
    if (around < 2.0 * half_window || around + 2.0 * half_window > profile.end()) {
        return std::nullopt;
    }
    const std::optional<double> minimum = profile.minimum_near(around);
    if (!minimum) {
        return std::nullopt;
    }
    const double r = *minimum;
    const Cubic cubic = profile.cubic(r);
    const Eigen::Vector4d fitted = cubic * numbers;

    Cubic best = cubic;
    double highest = fitted[0];
    for (Index k = profile.shell_of(r) + 1; profile.middle(k) + half_window < profile.end(); ++k) {
        const Cubic behind = profile.cubic(profile.middle(k));
        if (const double value = behind.row(0).dot(numbers); value > highest) {
            highest = value;
            best = behind;
        }
    }
    const Estimate rise = shells_.estimate(highest - fitted[0], best.row(0) - cubic.row(0));
    if (!rise.converged || !(rise.mean > significance * rise.standard_error)) {
        return std::nullopt;
    }

    // Atoms are taken as evenly spread within a shell, because the density hardly varies around its minimum.
    const Index shell = profile.shell_of(r);
    const double begin = division_.width * static_cast<double>(shell);
    const double share =
        integral_of_powers(begin, r, 0.0)[0] / integral_of_powers(begin, begin + division_.width, 0.0)[0];
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(division_.shells);
    gradient.head(shell).setOnes();
    gradient[shell] = share;
    if (profile.density(shell) > 0.0) {
        constexpr double step = 1e-4;
        const double slope_change = (profile.slope(r + step) - profile.slope(r - step)) / (2.0 * step);
        const Eigen::VectorXd place_gradient = -cubic.row(1).transpose() / slope_change;
        if (!(shells_.estimate(r, place_gradient).standard_error < largest_place_error)) {
            return std::nullopt;
        }
        gradient += sphere * r * r * profile.density(shell) * place_gradient;
    }
    return shells_.estimate(numbers.head(shell).sum() + share * numbers[shell], gradient);
}

ObservableAverage CoordinationNumber::observable() const {
    ObservableAverage average = average_of("coordination_number", estimate());
    if (!average.estimate) {
        average.remark = "g(r) has no first minimum that stands out of its noise";
    }
    return average;
}

}  // namespace ljmd
