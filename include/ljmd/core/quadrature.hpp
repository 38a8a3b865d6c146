#pragma once

#include <functional>

namespace ljmd {

/// Integral of f from a to b (b may be infinity) by GSL's adaptive Gauss-Kronrod rules, to a relative error of 1e-12 or
/// an absolute one of 1e-15, whichever is larger; a thousand times that where round-off allows no better.
/// @throws PhysicsError when the integral does not converge
[[nodiscard]] double integrate(const std::function<double(double)>& f, double a, double b);

}  // namespace ljmd
