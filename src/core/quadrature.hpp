#pragma once

#include <functional>

namespace ljmd {

/// Integral of f from a to b (b may be infinity) by GSL's adaptive Gauss-Kronrod rules. The error is at most 1e-12
/// relative or 1e-15 absolute, whichever is larger; a thousand times that where round-off prevents better.
/// @throws PhysicsError if the integral does not converge
[[nodiscard]] double integrate(const std::function<double(double)>& f, double a, double b);

}  // namespace ljmd
