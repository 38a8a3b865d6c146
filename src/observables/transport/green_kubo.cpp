#include "observables/transport/green_kubo.hpp"

#include <cmath>
#include <limits>

namespace ljmd {

namespace {

constexpr double change_without_error = 0.05;  // fraction of the integral
constexpr double rounding = 1e-12;             // fraction of the integral, for series without fluctuations

double trapezoids(const Eigen::VectorXd& values, Index last, Index stride) {
    double sum = 0.0;
    for (Index k = stride; k <= last; k += stride) {
        sum += 0.5 * static_cast<double>(stride) * (values[k - stride] + values[k]);
    }
    return sum;
}

}  // namespace

double change_at_double_spacing(const Eigen::VectorXd& values, double spacing) {
    const Index last = (values.size() - 1) / 2 * 2;
    if (last < 2) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return spacing * (trapezoids(values, last, 2) - trapezoids(values, last, 1));
}

bool frames_are_close(const Estimate& integral, double change) {
    return !std::isfinite(integral.standard_error) ||
           std::abs(change) <= integral.standard_error + rounding * std::abs(integral.mean);
}

ObservableAverage green_kubo_integral(ObservableAverage integral, double change) {
    const Estimate& estimate = integral.estimate.value();
    const bool unknown = !std::isfinite(estimate.standard_error);
    if (!frames_are_close(estimate, change) ||
        (unknown && !(std::abs(change) <= change_without_error * std::abs(estimate.mean)))) {
        integral.estimate.reset();
        integral.remark = "configurations are too far apart in time: with every second one the integral is another";
        return integral;
    }
    return integral;
}

}  // namespace ljmd
