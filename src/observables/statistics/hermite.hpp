#pragma once

#include <cmath>

namespace ljmd {

/// Cubic Hermite polynomial: a quantity within one time step, from its values and rates at both ends.
///
///     x(t0 + s h) = x0 + w (x1 - x0) + h s (1-s) [(1-s) v0 - s v1],  w = s^2 (3 - 2 s),  0 <= s <= 1
///
/// The error of the value is at most h^4/384 max|x''''|; the error of the rate is O(h^3).
/// Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I (1993), section II.6.
/// @tparam T  double or Vec3
template <class T>
struct HermiteStep {
    double start;   ///< t0
    double length;  ///< h, positive
    T x0;           ///< value at t0
    T v0;           ///< dx/dt at t0
    T x1;           ///< value at t0 + h
    T v1;           ///< dx/dt at t0 + h

    [[nodiscard]] double time(double s) const { return start + s * length; }

    [[nodiscard]] T value(double s) const {
        const double u = 1.0 - s;
        return x0 + s * s * (3.0 - 2.0 * s) * (x1 - x0) + length * s * u * (u * v0 - s * v1);
    }

    /// dx/dt of the polynomial.
    [[nodiscard]] T rate(double s) const {
        const double u = 1.0 - s;
        return 6.0 * s * u / length * (x1 - x0) + u * (1.0 - 3.0 * s) * v0 - s * (2.0 - 3.0 * s) * v1;
    }
};

/// A sign change of a continuous f in a step, 0 <= s <= 1, by bisection to 1e-18.
/// @pre f(0) and f(1) have opposite signs; with several sign changes the result is one of them
template <class Function>
[[nodiscard]] double root_in_step(const Function& f) {
    constexpr int bisections = 60;
    const bool sign_at_start = std::signbit(f(0.0));
    double low = 0.0;
    double high = 1.0;
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (low + high);
        (std::signbit(f(middle)) == sign_at_start ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace ljmd
