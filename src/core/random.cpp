#include "ljmd/core/random.hpp"

#include <Random123/philox.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ljmd {

namespace {

using Philox = r123::Philox4x64;

Philox::ctr_type draw(std::uint64_t seed, RandomStream stream, Index step, Index atom) {
    Philox::ctr_type counter = {{static_cast<std::uint64_t>(step), static_cast<std::uint64_t>(atom), 0, 0}};
    Philox::key_type key = {{seed, static_cast<std::uint64_t>(stream)}};
    return Philox{}(counter, key);
}

/// The upper 53 bits as a number in [0, 1).
double fraction(std::uint64_t bits) {
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// An unlimited sequence for algorithms of GSL, numbered by the third word of the counter.
struct Sequence {
    Philox::ctr_type counter;
    Philox::key_type key;
    Philox::ctr_type block{};
    std::size_t left = 0;

    std::uint64_t next() {
        if (left == 0) {
            ++counter[2];
            block = Philox{}(counter, key);
            left = block.size();
        }
        return block[--left];
    }
};

unsigned long next_word(void* sequence) {
    return static_cast<Sequence*>(sequence)->next() >> 32U;
}

double next_fraction(void* sequence) {
    return fraction(static_cast<Sequence*>(sequence)->next());
}

constexpr gsl_rng_type philox_type{"philox4x64", 0xffffffffUL, 0, sizeof(Sequence), [](void*, unsigned long) {},
                                   next_word,    next_fraction};

}  // namespace

Vec3 Random::uniform(Index step, Index atom) const {
    const auto bits = draw(seed_, stream_, step, atom);
    return {fraction(bits[0]), fraction(bits[1]), fraction(bits[2])};
}

Vec3 Random::normal(Index step, Index atom) const {
    const auto bits = draw(seed_, stream_, step, atom);
    // 1 - [0, 1) excludes zero, whose logarithm is infinite.
    const double radius_a = std::sqrt(-2.0 * std::log(1.0 - fraction(bits[0])));
    const double radius_b = std::sqrt(-2.0 * std::log(1.0 - fraction(bits[2])));
    const double angle_a = 2.0 * std::numbers::pi * fraction(bits[1]);
    const double angle_b = 2.0 * std::numbers::pi * fraction(bits[3]);
    return {radius_a * std::cos(angle_a), radius_a * std::sin(angle_a), radius_b * std::cos(angle_b)};
}

double Random::gamma(Index step, Index atom, double shape) const {
    Sequence sequence{{{static_cast<std::uint64_t>(step), static_cast<std::uint64_t>(atom), 0, 0}},
                      {{seed_, static_cast<std::uint64_t>(stream_)}}};
    const gsl_rng generator{&philox_type, &sequence};
    return gsl_ran_gamma(&generator, shape, 1.0);
}

}  // namespace ljmd
