#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "ljmd/core/types.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// Coordinates as 32-bit whole numbers of a power of two, counted from the middle of the box. Their differences are
/// exact, so separations have the same absolute precision everywhere in the box (about 2^-29 of its edge), unlike
/// differences of single-precision coordinates. They take half the memory of doubles.
class FixedPoint {
  public:
    FixedPoint() = default;

    /// For points up to `halo` outside the box. @pre halo >= 0
    FixedPoint(const Box& box, double halo)
        : origin_(0.5 * box.edges()),
          unit_(power_of_two((0.5 * box.edges().maxCoeff() + halo) / largest)),
          per_unit_(1.0 / unit_) {}

    /// Length of one unit [sigma].
    [[nodiscard]] double unit() const { return unit_; }
    /// Position of the coordinate 0 [sigma].
    [[nodiscard]] const Vec3& origin() const { return origin_; }

    /// The nearest whole number to a coordinate [sigma]. @pre inside the box and its halo, or hardly outside
    [[nodiscard]] std::int32_t operator()(double x, int axis) const {
        // Adding `shift` makes doubles lie 1 apart, so that the low bits are the whole number. Faster than std::lrint.
        constexpr double shift = 0x1.8p52;
        return static_cast<std::int32_t>(std::bit_cast<std::int64_t>((x - origin_[axis]) * per_unit_ + shift));
    }

    /// The nearest whole number to a difference of two coordinates [sigma].
    [[nodiscard]] std::int32_t distance(double dx) const {
        return static_cast<std::int32_t>(std::lround(dx * per_unit_));
    }

    /// Coordinate for slots without an atom. Its difference from any point neither overflows nor is shorter than the
    /// halo.
    static constexpr std::int32_t far_away = 1 << 30;

  private:
    static constexpr double largest = 0x1p29;

    /// The smallest power of two that is not below x.
    static double power_of_two(double x) {
        int exponent = 0;
        const double mantissa = std::frexp(x, &exponent);  // from 0.5 to 1
        return std::ldexp(1.0, mantissa > 0.5 ? exponent : exponent - 1);
    }

    Vec3 origin_ = Vec3::Zero();
    double unit_ = 1.0;
    double per_unit_ = 1.0;  ///< exact: unit_ is a power of two
};

}  // namespace ljmd
