#pragma once

#include <cmath>
#include <cstdint>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// A force component as a sum of pair terms, in floating point: the result depends on the order of the terms by
/// rounding.
class FloatingSum {
  public:
    void add(double term) { sum_ += term; }
    [[nodiscard]] double value() const { return sum_; }

  private:
    double sum_ = 0.0;
};

/// The same in fixed point: each term is rounded to a multiple of 2^-44 [epsilon/sigma] and added as an integer, so the
/// result is the same to the last bit in whatever order the terms come. Half a unit is 3e-14, a hundredth of what
/// rounding does to a sum of floating-point terms of a liquid.
///
/// @throws PhysicsError (from value()) when the terms together, without their signs, reach 2^18 epsilon/sigma: the sum
/// could
///         leave the range of the integers
/// Source: Levesque and Verlet (1993), J. Stat. Phys. 72, 519, on why this matters
class FixedPointSum {
  public:
    void add(double term) {
        bound_ += std::abs(term);
        sum_ += static_cast<std::uint64_t>(std::llrint(term * scale));
    }

    [[nodiscard]] double value() const {
        if (!(bound_ < largest)) {  // true for NaN as well
            throw PhysicsError(
                "forces reach 2^18 epsilon/sigma, the range of fixed-point sums: the run has "
                "blown up. Is the time step too large, or do atoms overlap at the start?");
        }
        return static_cast<double>(static_cast<std::int64_t>(sum_)) / scale;
    }

  private:
    static constexpr double scale = 0x1p44;
    static constexpr double largest = 0x1p18;
    std::uint64_t sum_ = 0;  // two's complement; unsigned, because what NaN becomes may overflow
    double bound_ = 0.0;     // no partial sum is larger
};

}  // namespace ljmd
