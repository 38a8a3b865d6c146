#pragma once

#include <Eigen/Core>

#include "ljmd/observables/statistics/observable_average.hpp"

namespace ljmd {

/// By how much the trapezoidal rule over equally spaced values changes when it takes every second of them only, up to
/// the longest even number of spacings. NaN for fewer than three values: there is no such rule.
[[nodiscard]] double change_at_double_spacing(const Eigen::VectorXd& values, double spacing);

/// Whether frames follow each other closely enough for the integral of a correlation: with every second frame it must
/// be the same within its standard error. True where fewer than four windows leave it without one.
///
/// The trapezoidal rule over frames that are farther apart than the correlation lasts gives C(0)/2 times their
/// distance, with a small error, and twice that with every second frame.
/// @param change  mean of change_at_double_spacing, in the unit of the integral
[[nodiscard]] bool frames_are_close(const Estimate& integral, double change);

/// An integral over windows as an observable: without value, and with a remark, where frames are too far apart; where
/// it has no error, if every second frame changes it by more than 5 %.
///
/// Windows are twice as long as the largest time, so that they know little of each other: eight of them tell the error
/// to 27 %, and it counts as converged.
[[nodiscard]] ObservableAverage green_kubo_integral(ObservableAverage integral, double change);

}  // namespace ljmd
