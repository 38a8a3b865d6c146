#include "core/random.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

namespace {

using Counter = std::array<std::uint64_t, 4>;
using PhiloxKey = std::array<std::uint64_t, 2>;

/// Philox-4x64 with ten rounds: multipliers, and the steps by which the key goes on from round to round, from Salmon et
/// al. (2011).
Counter philox(Counter c, PhiloxKey key) {
    __extension__ using Wide = unsigned __int128;
    constexpr int rounds = 10;
    for (int round = 0; round < rounds; ++round) {
        const Wide a = Wide{0xD2E7470EE14C6C93U} * c[0];
        const Wide b = Wide{0xCA5A826395121157U} * c[2];
        c = {static_cast<std::uint64_t>(b >> 64U) ^ c[1] ^ key[0], static_cast<std::uint64_t>(b),
             static_cast<std::uint64_t>(a >> 64U) ^ c[3] ^ key[1], static_cast<std::uint64_t>(a)};
        key[0] += 0x9E3779B97F4A7C15U;
        key[1] += 0xBB67AE8584CAA73BU;
    }
    return c;
}

Counter first_counter(Index step, Index atom) {
    return {static_cast<std::uint64_t>(step), static_cast<std::uint64_t>(atom), 0, 0};
}

Counter draw(std::uint64_t seed, RandomStream stream, Index step, Index atom) {
    return philox(first_counter(step, atom), {seed, static_cast<std::uint64_t>(stream)});
}

/// The upper 53 bits as a number in [0, 1).
double fraction(std::uint64_t bits) {
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// sqrt(-2 ln f): the distance from the origin of a point whose coordinates are two normal numbers. 1 - [0, 1) excludes
/// zero, whose logarithm is infinite.
double radius(double f) {
    return std::sqrt(-2.0 * logarithm(1.0 - f));
}

/// An unlimited sequence, numbered by the third word of the counter.
class Sequence {
  public:
    Sequence(const Counter& counter, const PhiloxKey& key) : counter_(counter), key_(key) {}

    double uniform() {
        if (left_ == 0) {
            ++counter_[2];
            block_ = philox(counter_, key_);
            left_ = block_.size();
        }
        return fraction(block_[--left_]);
    }

    double normal() {
        const double distance = radius(uniform());
        return distance * of_turns(uniform()).cosine;
    }

  private:
    Counter counter_;
    PhiloxKey key_;
    Counter block_{};
    std::size_t left_ = 0;
};

}  // namespace

Vec3 Random::uniform(Index step, Index atom) const {
    const auto bits = draw(seed_, stream_, step, atom);
    return {fraction(bits[0]), fraction(bits[1]), fraction(bits[2])};
}

Vec3 Random::normal(Index step, Index atom) const {
    const auto bits = draw(seed_, stream_, step, atom);
    const double radius_a = radius(fraction(bits[0]));
    const double radius_b = radius(fraction(bits[2]));
    const auto [sine_a, cosine_a] = of_turns(fraction(bits[1]));
    return {radius_a * cosine_a, radius_a * sine_a, radius_b * of_turns(fraction(bits[3])).cosine};
}

double Random::gamma(Index step, Index atom, double shape) const {
    Sequence sequence(first_counter(step, atom), {seed_, static_cast<std::uint64_t>(stream_)});
    // With d = shape - 1/3 and c = 1/sqrt(9 d), d (1 + c x)^3 of a normal x is nearly such a number; the rest is done
    // by rejection. Below 1 from a number of shape + 1, times u^(1/shape).
    const double d = (shape < 1.0 ? shape + 1.0 : shape) - 1.0 / 3.0;
    const double c = 1.0 / std::sqrt(9.0 * d);
    while (true) {
        const double x = sequence.normal();
        const double root = 1.0 + c * x;
        if (root <= 0.0) {
            continue;
        }
        const double v = root * root * root;
        const double u = 1.0 - sequence.uniform();
        if (logarithm(u) < 0.5 * x * x + d * (1.0 - v + logarithm(v))) {
            return shape < 1.0 ? d * v * exponential(logarithm(1.0 - sequence.uniform()) / shape) : d * v;
        }
    }
}

}  // namespace ljmd
