#include "ljmd/core/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace ljmd {

namespace {

using Philox = r123::Philox4x64;

Philox::ctr_type draw(std::uint64_t seed, RandomStream stream, Index step, Index atom) {
    Philox::ctr_type counter = {{static_cast<std::uint64_t>(step), static_cast<std::uint64_t>(atom), 0, 0}};
    Philox::key_type key = {{seed, static_cast<std::uint64_t>(stream)}};
    return Philox{}(counter, key);
}

/// The upper 53 bits as a fraction in [0, 1).
double fraction(std::uint64_t bits) {
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

}  // namespace

Vec3 Random::uniform(Index step, Index atom) const {
    const auto bits = draw(seed_, stream_, step, atom);
    return {fraction(bits[0]), fraction(bits[1]), fraction(bits[2])};
}

Vec3 Random::normal(Index step, Index atom) const {
    const auto bits = draw(seed_, stream_, step, atom);
    // 1 - [0, 1) excludes zero, of which the logarithm would be infinite.
    const double radius_a = std::sqrt(-2.0 * std::log(1.0 - fraction(bits[0])));
    const double radius_b = std::sqrt(-2.0 * std::log(1.0 - fraction(bits[2])));
    const double angle_a = 2.0 * std::numbers::pi * fraction(bits[1]);
    const double angle_b = 2.0 * std::numbers::pi * fraction(bits[3]);
    return {radius_a * std::cos(angle_a), radius_a * std::sin(angle_a), radius_b * std::cos(angle_b)};
}

}  // namespace ljmd
