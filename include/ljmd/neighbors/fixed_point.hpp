#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "ljmd/core/types.hpp"
#include "ljmd/model/box.hpp"

namespace ljmd {

/// Coordinates as 32-bit whole numbers of a power of two, counted from the middle of the box. Their differences are
/// exact, so a separation is known to the same absolute precision everywhere in the box (about 2^-29 of its edge),
/// which single-precision coordinates cannot offer; and comparing them takes half the room of doubles.
class FixedPoint {
  public:
    FixedPoint() = default;

    /// For points up to `halo` outside the box. @pre halo >= 0
    FixedPoint(const Box& box, double halo)
        : origin_(0.5 * box.edges()),
          unit_(std::exp2(std::ceil(std::log2((0.5 * box.edges().maxCoeff() + halo) / largest)))),
          per_unit_(1.0 / unit_) {}

    /// What 1 stands for [sigma].
    [[nodiscard]] double unit() const { return unit_; }
    /// What stands for 0 [sigma].
    [[nodiscard]] const Vec3& origin() const { return origin_; }

    /// The nearest whole number. @pre inside the box and its halo, or hardly outside
    [[nodiscard]] std::int32_t operator()(double x, int axis) const {
        // Where doubles lie 1 apart, the last bits of one are the whole number: faster than calls of std::lrint.
        constexpr double shift = 0x1.8p52;
        return static_cast<std::int32_t>(std::bit_cast<std::int64_t>((x - origin_[axis]) * per_unit_ + shift));
    }

    /// The nearest whole number to a difference of two coordinates.
    [[nodiscard]] std::int32_t distance(double dx) const {
        return static_cast<std::int32_t>(std::lround(dx * per_unit_));
    }

    /// Out of reach of every point: no difference from it overflows, none is shorter than the halo.
    static constexpr std::int32_t far_away = 1 << 30;

  private:
    static constexpr double largest = 0x1p29;

    Vec3 origin_ = Vec3::Zero();
    double unit_ = 1.0;
    double per_unit_ = 1.0;  ///< exact: unit_ is a power of two
};

}  // namespace ljmd
