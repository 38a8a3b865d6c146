#pragma once

#include <cmath>
#include <cstdint>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// Sum of pair terms, one force component, in floating point. Rounding makes it depend on the order of the terms.
class FloatingSum {
  public:
    void add(double term) { sum_ += term; }
    [[nodiscard]] double value() const { return sum_; }

  private:
    double sum_ = 0.0;
};

/// Sum of pair terms, one force component, in fixed point. Each term is rounded to a multiple of 2^-44 [epsilon/sigma]
/// and added as an integer, so the sum does not depend on the order of the terms. The rounding error of a term, at most
/// 3e-14, is a hundredth of the rounding error of a floating-point sum in a liquid.
///
/// @throws PhysicsError (from value()) if the magnitudes of the terms add up to 2^18 epsilon/sigma or more, because the
/// sum could overflow
/// Source: Levesque and Verlet (1993), J. Stat. Phys. 72, 519: reversibility needs order-independent sums
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
    std::uint64_t sum_ = 0;  // two's complement; unsigned, because a NaN converted to an integer may make it overflow
    double bound_ = 0.0;     // sum of magnitudes; no partial sum is larger
};

}  // namespace ljmd
