#include "ljmd/detail/core/elementary.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ljmd {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A number as the sum of two. The second is at most half a unit in the last place of the first.
struct Pair {
    double high;
    double low;
};

/// a + b exactly. @pre |a| >= |b|, or a is 0
Pair exact_sum(double a, double b) {
    const double sum = a + b;
    return {sum, b - (sum - a)};
}

/// The same for any two. (Knuth, The art of computer programming 2, 4.2.2)
Pair sum_of(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

/// The upper 26 bits of a number: products of two such are exact. (Dekker 1971, doi:10.1007/BF01397083)
double upper_half(double x) {
    const double scaled = x * 0x1.0000002p27;
    return scaled - (scaled - x);
}

/// a b exactly, unless it underflows.
Pair exact_product(double a, double b) {
    const double product = a * b;
    const double a1 = upper_half(a);
    const double a2 = a - a1;
    const double b1 = upper_half(b);
    const double b2 = b - b1;
    return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

/// Horner's rule.
template <std::size_t count>
double polynomial(const double (&c)[count], double x) {
    double sum = c[count - 1];
    for (std::size_t k = count - 1; k-- > 0;) {
        sum = sum * x + c[k];
    }
    return sum;
}

/// 2^k. @pre from -1022 to 1023
double power_of_two(int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52U);
}

/// m 2^k for m near 1, rounded once.
double scaled(double m, int k) {
    if (k >= -1021 && k <= 1023) {
        return m * power_of_two(k);
    }
    return k > 0 ? m * 2.0 * power_of_two(k - 1) : m * power_of_two(k + 100) * power_of_two(-100);
}

constexpr double ln2_high = 0x1.62e42feep-1;       // 32 bits: a whole number of 20 bits times it is exact
constexpr double ln2_low = 0x1.a39ef35793c76p-33;  // the rest

/// e^r - 1 for |r| <= ln(2)/2, r = high + low: r + r^2/2 + r^3 (1/6 + r/24 + ...), its first two terms to twice the
/// digits of a double.
Pair exponential_minus_one(Pair r) {
    static constexpr double inverse_factorials[] = {
        1.0 / 6,      1.0 / 24,      1.0 / 120,      1.0 / 720,       1.0 / 5040,       1.0 / 40320,
        1.0 / 362880, 1.0 / 3628800, 1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800, 1.0 / 87178291200};
    const Pair square = exact_product(r.high, r.high);
    const double rest =
        r.high * square.high * polynomial(inverse_factorials, r.high) + (0.5 * square.low + r.low + r.high * r.low);
    const Pair sum = exact_sum(r.high, 0.5 * square.high);
    return exact_sum(sum.high, sum.low + rest);
}

/// x = k ln 2 + r. @pre |x| < 750
struct Reduced {
    int k;
    Pair r;
};

Reduced by_ln2(double x) {
    const double shifted = x * 1.4426950408889634 + 0x1.8p52;  // the nearest whole number, in the lowest bits
    const double k = shifted - 0x1.8p52;
    return {static_cast<int>(k), exact_sum(x - k * ln2_high, -(k * ln2_low))};
}

/// sin x and cos x for |x| <= pi/4, x = high + low.
SineAndCosine of_small_angle(Pair x) {
    static constexpr double sine[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                                      -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    static constexpr double cosine[] = {
        1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
        1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};
    const Pair square = exact_product(x.high, x.high);
    const double half = 0.5 * square.high;
    const double s = x.high + (x.low * (1.0 - half) + x.high * square.high * polynomial(sine, square.high));
    const Pair c = exact_sum(1.0, -half);
    return {s, c.high + (c.low - (0.5 * square.low + x.high * x.low) +
                         square.high * square.high * polynomial(cosine, square.high))};
}

SineAndCosine turned(SineAndCosine a, int quarters) {
    switch (quarters & 3) {
        case 0:
            return a;
        case 1:
            return {a.cosine, -a.sine};
        case 2:
            return {-a.sine, -a.cosine};
        default:
            return {-a.cosine, a.sine};
    }
}

}  // namespace

double logarithm(double x) {
    if (!(x > 0.0) || x == infinite) {
        return x == 0.0 ? -infinite : x == infinite ? x : not_a_number;
    }
    // x = 2^k m with m from sqrt(1/2) to sqrt(2), f = m - 1, s = f/(2 + f):
    // log m = 2 artanh s = f - f^2/2 + s (f^2/2 + r), r = 2 s^2/3 + 2 s^4/5 + ...
    int k = 0;
    if (x < std::numeric_limits<double>::min()) {
        x *= 0x1p54;
        k = -54;
    }
    auto bits = std::bit_cast<std::uint64_t>(x);
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdU;
    const std::uint64_t above = bits - root_half;
    k += static_cast<int>(static_cast<std::int64_t>(above) >> 52);
    bits = (above & 0x000fffffffffffffU) + root_half;
    const double f = std::bit_cast<double>(bits) - 1.0;
    const double s = f / (2.0 + f);
    static constexpr double odd[] = {2.0 / 3,  2.0 / 5,  2.0 / 7,  2.0 / 9,  2.0 / 11,
                                     2.0 / 13, 2.0 / 15, 2.0 / 17, 2.0 / 19, 2.0 / 21};
    const double z = s * s;
    const double r = z * polynomial(odd, z);
    const double half_square = 0.5 * f * f;
    const double n = k;
    return n * ln2_high - ((half_square - (s * (half_square + r) + n * ln2_low)) - f);
}

double exponential(double x) {
    if (!(x > -746.0 && x < 710.0)) {
        return x != x ? x : x > 0.0 ? infinite : 0.0;
    }
    const auto [k, r] = by_ln2(x);
    const Pair e = exponential_minus_one(r);
    const Pair sum = exact_sum(1.0, e.high);
    return scaled(sum.high + (sum.low + e.low), k);
}

double exponential_minus_one(double x) {
    if (!(x > -40.0 && x < 710.0)) {
        return x != x ? x : x > 0.0 ? infinite : -1.0;
    }
    if (x > -0x1p-54 && x < 0x1p-54) {
        return x;
    }
    const auto [k, r] = by_ln2(x);
    const Pair e = exponential_minus_one(r);
    if (k == 0) {
        return e.high + e.low;
    }
    if (k > 60) {
        return exponential(x);
    }
    // 2^k (e - (2^-k - 1))
    const double less = 1.0 - scaled(1.0, -k);
    const Pair sum = sum_of(less, e.high);
    return scaled(sum.high + (sum.low + e.low), k);
}

double cube_root(double x) {
    if (x == 0.0 || x != x || x == infinite || x == -infinite) {
        return x;
    }
    const double size = x < 0.0 ? -x : x;
    const bool tiny = size < std::numeric_limits<double>::min();
    const auto bits = std::bit_cast<std::uint64_t>(tiny ? size * 0x1p54 : size);
    const int exponent = static_cast<int>(bits >> 52U) - 1023 + (tiny ? -54 : 0);
    const int third = (exponent + 1500) / 3 - 500;  // rounded down
    const double m =
        std::bit_cast<double>((bits & 0x000fffffffffffffU) | 0x3ff0000000000000U) * (exponent == 3 * third       ? 1.0
                                                                                     : exponent == 3 * third + 1 ? 2.0
                                                                                                                 : 4.0);
    // Halley's rule from the straight line through the ends, within 10 % from 1 to 8: three digits become nine, then
    // all.
    double t = 0.86 + m / 7.0;
    for (int n = 0; n < 3; ++n) {
        const double cube = t * t * t;
        t = t * (cube + 2.0 * m) / (2.0 * cube + m);
    }
    // The rest of the cube with t cut to 26 bits, whose square is exact.
    t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(t) & 0xfffffffff8000000U);
    const double quotient = m / (t * t);
    t += t * (quotient - t) / (2.0 * t + quotient);
    const double root = scaled(t, third);
    return x < 0.0 ? -root : root;
}

SineAndCosine of_turns(double turns) {
    // The nearest quarter and the rest of a turn, both exact.
    const double whole = std::nearbyint(4.0 * turns);
    const double rest = turns - 0.25 * whole;
    constexpr double two_pi_high = 0x1.921fb54442d18p+2;
    constexpr double two_pi_low = 0x1.1a62633145c07p-52;
    const Pair angle = exact_product(rest, two_pi_high);
    return turned(of_small_angle(exact_sum(angle.high, angle.low + rest * two_pi_low)),
                  static_cast<int>(whole - 4.0 * std::floor(0.25 * whole)));
}

double sine(double x) {
    constexpr double largest = 0x1p50;  // whole turns are not known beyond, for want of digits
    if (!(x > -largest && x < largest)) {
        return x - x;
    }
    // x = k pi/2 + r, with pi in three parts.
    const double k = std::nearbyint(x * 0x1.45f306dc9c883p-1);
    const Pair first = exact_product(k, 0x1.921fb54442d18p+0);
    const Pair second = exact_product(k, 0x1.1a62633145c07p-54);
    const Pair a = sum_of(x - first.high, -first.low);
    const Pair b = sum_of(a.high, -second.high);
    const Pair r = exact_sum(b.high, b.low + a.low - second.low - k * -0x1.f1976b7ed8fbcp-110);
    return turned(of_small_angle(r), static_cast<int>(k - 4.0 * std::floor(0.25 * k))).sine;
}

}  // namespace ljmd
