#pragma once

#include <Eigen/Core>

#include "ljmd/detail/observables/statistics/observable_average.hpp"

namespace ljmd {

/// Change of the trapezoidal rule over equally spaced values if it uses only every second value, up to the largest even
/// number of intervals. NaN for fewer than three values.
[[nodiscard]] double change_at_double_spacing(const Eigen::VectorXd& values, double spacing);

/// Whether frames are close enough in time for the integral of a correlation: with every second frame it must be the
/// same within its standard error. True if there is no standard error, with fewer than four windows.
///
/// If frames are farther apart than the correlation lasts, the trapezoidal rule gives C(0)/2 times their distance, with
/// a small error, and twice that with every second frame.
/// @param change  mean of change_at_double_spacing, in the units of the integral
[[nodiscard]] bool frames_are_close(const Estimate& integral, double change);

/// Turn an integral over windows into an observable. It has a remark instead of a value if frames are too far apart;
/// without a standard error, if using every second frame changes the integral by more than 5 %.
///
/// Windows are twice as long as the largest time, so that they are nearly independent. The error is a guess by the rule
/// for all series (BlockingAccumulator): with fewer than 16 independent ones.
[[nodiscard]] ObservableAverage green_kubo_integral(ObservableAverage integral, double change);

}  // namespace ljmd
