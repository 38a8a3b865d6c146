#pragma once

#include <functional>

namespace ljmd {

/// A root of a continuous f between a and b, to the precision of doubles, by Brent's method (GSL).
/// @throws PhysicsError unless f(a) and f(b) are finite and differ in sign, or one of them is zero
[[nodiscard]] double find_root(const std::function<double(double)>& f, double a, double b);

}  // namespace ljmd
