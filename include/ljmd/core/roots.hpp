#pragma once

#include <functional>

namespace ljmd {

/// A root of a continuous f between a and b, by Brent's method (GSL), as closely as doubles allow.
/// @pre f(a) and f(b) are finite and differ in sign, or one of them is zero; else PhysicsError
[[nodiscard]] double find_root(const std::function<double(double)>& f, double a, double b);

}  // namespace ljmd
