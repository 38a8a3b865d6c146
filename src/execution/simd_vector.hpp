#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "execution/simd_intrinsics.hpp"

/// Vectors of numbers for code that is compiled once for each SIMD level.
///
/// The translation units of a level are compiled with its flags and with LJMD_SIMD_LEVEL, the name of the level. `Here`
/// is then a type of that level alone. Every template that they instantiate depends on it, so the linker never takes a
/// function compiled for one processor in place of the same one compiled for another. Of the standard library only
/// plain functions are called.
///
/// LJMD_SIMD_256 marks the level with the instructions and registers of AVX-512 for vectors of 256 bits,
/// LJMD_SIMD_FOR_INTEL the one for processors whose divisions are slow and whose multipliers also add.
///
/// The arithmetic is done by the compilers' vector extension (gcc 12, clang); simd_intrinsics.hpp adds what it lacks.
namespace ljmd::simd {

/// A vector of `lanes` numbers of type T. Operators act on each lane and round as T's operators do; nothing is fused
/// except by multiply_add().
/// @tparam Level  tag of the SIMD level, see above
template <class T, int lanes_, class Level>
struct Vec {
    static constexpr int lanes = lanes_;
    using Value = T;
    using Raw = RawVector<T, lanes_>;

    Raw raw;

    Vec() = default;
    LJMD_INLINE explicit Vec(Raw r) : raw(r) {}
    /// All lanes equal to x.
    template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
    LJMD_INLINE explicit Vec(Number x) : raw(static_cast<T>(x) - Raw{}) {}

    /// @pre aligned to the vector's own size
    LJMD_INLINE static Vec load(const T* from) { return Vec(load_aligned<T, lanes_>(from)); }
    LJMD_INLINE void store(T* to) const {
        __builtin_memcpy(__builtin_assume_aligned(to, sizeof(Raw)), &raw, sizeof raw);
    }
    LJMD_INLINE static Vec load_unaligned(const T* from) {
        Vec v;
        __builtin_memcpy(&v.raw, from, sizeof v.raw);
        return v;
    }

    LJMD_INLINE friend Vec operator+(Vec a, Vec b) { return Vec(a.raw + b.raw); }
    LJMD_INLINE friend Vec operator-(Vec a, Vec b) { return Vec(a.raw - b.raw); }
    LJMD_INLINE friend Vec operator*(Vec a, Vec b) { return Vec(a.raw * b.raw); }
    LJMD_INLINE friend Vec operator/(Vec a, Vec b) { return Vec(a.raw / b.raw); }
    LJMD_INLINE friend Vec operator-(Vec a) { return Vec(-a.raw); }
    LJMD_INLINE Vec& operator+=(Vec b) { return *this = *this + b; }

    /// a b + c, see multiply_add() of raw vectors.
    LJMD_INLINE friend Vec multiply_add(Vec a, Vec b, Vec c) {
        return Vec(simd::multiply_add<T, lanes_>(a.raw, b.raw, c.raw));
    }

    /// Add a b to both sums. Where separate units add and multiply at the same time, the product is rounded once and
    /// added twice. Where the multipliers also add, it is fused with each sum.
    LJMD_INLINE friend void add_product(Vec a, Vec b, Vec& one, Vec& other) {
        if constexpr (multipliers_add) {
            one = multiply_add(a, b, one);
            other = multiply_add(a, b, other);
        } else {
            const Vec product = a * b;
            one += product;
            other += product;
        }
    }

    LJMD_INLINE friend Vec sqrt(Vec a) { return Vec(square_root<T, lanes_>(a.raw)); }
    static constexpr bool has_inverse_root = simd::has_inverse_root<T, lanes_>;
    /// 1/sqrt(a). @pre has_inverse_root
    LJMD_INLINE friend Vec inverse_root(Vec a) { return Vec(native::inverse_root(a.raw)); }

    /// Larger one of each lane; b where a is NaN.
    LJMD_INLINE friend Vec max(Vec a, Vec b) { return Vec(larger<T, lanes_>(a.raw, b.raw)); }

    /// x in the lanes where a < b, 0 elsewhere, even where x is infinite or NaN.
    LJMD_INLINE friend Vec where_less(Vec a, Vec b, Vec x) {
        return Vec(keep_where_less<T, lanes_>(a.raw, b.raw, x.raw));
    }
};

/// 1/a and 1/b from 1/(a b), each within 2 units in the last place.
/// @pre neither a b nor 1/(a b) overflows. If a or b is 0, both results may be NaN.
template <class V>
LJMD_INLINE void by_one_division(V a, V b, V& inverse_a, V& inverse_b) {
    const V inverse = V(1) / (a * b);
    inverse_a = inverse * b;
    inverse_b = inverse * a;
}

/// 1/a and 1/b, by a single division where divisions are slow. @pre see by_one_division
template <class V>
LJMD_INLINE void reciprocals(V a, V b, V& inverse_a, V& inverse_b) {
    if constexpr (divisions_are_slow) {
        by_one_division(a, b, inverse_a, inverse_b);
    } else {
        inverse_a = V(1) / a;
        inverse_b = V(1) / b;
    }
}

/// c[0] + c[1] x + c[2] x^2 + ... by Estrin's scheme, whose products are independent, while each product of Horner's
/// rule waits for the one before.
template <class V, std::size_t count>
LJMD_INLINE V polynomial(const V (&c)[count], V x) {
    if constexpr (count == 1) {
        return c[0];
    } else {
        V pairs[(count + 1) / 2];
        for (std::size_t k = 0; k + 1 < count; k += 2) {
            pairs[k / 2] = multiply_add(c[k + 1], x, c[k]);
        }
        if constexpr (count % 2 == 1) {
            pairs[count / 2] = c[count - 1];
        }
        return polynomial(pairs, x * x);
    }
}

/// e^x within 2 units in the last place for x from -708 (-87 in single precision) to 709 (88); smaller x count as -708
/// (-87).
///
/// x = k ln 2 + s, |s| <= ln(2)/2: e^x = 2^k e^s, with the Taylor polynomial of degree 13 (7) for e^s.
template <class T, int lanes, class Level>
LJMD_INLINE Vec<T, lanes, Level> exp(Vec<T, lanes, Level> x) {
    using V = Vec<T, lanes, Level>;
    using Bits = typename Integer<T>::Type;
    using RawBits = RawVector<Bits, lanes>;
    constexpr bool is_double = std::is_same_v<T, double>;
    constexpr int mantissa = is_double ? 52 : 23;
    constexpr int bias = is_double ? 1023 : 127;
    // Adding 1.5 * 2^mantissa leaves the nearest integer in the lowest bits of the sum.
    const V shift(is_double ? 0x1.8p52 : 0x1.8p23);
    const V lowest(is_double ? -708.0 : -87.0);
    x = max(x, lowest);
    const V shifted = multiply_add(x, V(1.4426950408889634), shift);
    const V k = shifted - shift;
    // ln 2 in two parts; the first ends in enough zeros for its product with k to be exact.
    const V s = multiply_add(k, V(is_double ? -0x1.a39ef35793c76p-33 : -0x1.7f7d1cp-20),
                             multiply_add(k, V(is_double ? -0x1.62e42feep-1 : -0x1.62e4p-1), x));
    V inverse_factorials[is_double ? 14 : 8];
    double factorial = 1.0;
    for (int n = 0; n < (is_double ? 14 : 8); ++n) {
        factorial *= n == 0 ? 1 : n;
        inverse_factorials[n] = V(1.0 / factorial);
    }
    const V sum = polynomial(inverse_factorials, s);
    const RawBits exponent = ((reinterpret<RawBits>(shifted.raw) - reinterpret<RawBits>(shift.raw)) + bias) << mantissa;
    return sum * V(reinterpret<typename V::Raw>(exponent));
}

/// Sum of all lanes; the two halves are added first.
template <int lanes>
LJMD_INLINE double sum_of(RawVector<double, lanes> v) {
    if constexpr (lanes == 2) {
        return v[0] + v[1];
    } else {
        return sum_of<lanes / 2>(low_half<double, lanes>(v) + high_half<double, lanes>(v));
    }
}

/// The lanes in double. In single precision the two halves of the vector are added, in double.
template <class Level, int lanes>
LJMD_INLINE Vec<double, lanes, Level> in_double(Vec<double, lanes, Level> v) {
    return v;
}
template <class Level, int lanes>
LJMD_INLINE Vec<double, lanes / 2, Level> in_double(Vec<float, lanes, Level> v) {
    return Vec<double, lanes / 2, Level>(widened<lanes / 2>(low_half<float, lanes>(v.raw)) +
                                         widened<lanes / 2>(high_half<float, lanes>(v.raw)));
}

/// Sum of all lanes, in double.
template <class V>
LJMD_INLINE double sum(V v) {
    const auto doubles = in_double(v);
    return sum_of<decltype(doubles)::lanes>(doubles.raw);
}

#ifdef LJMD_SIMD_LEVEL
/// Tag of the level that this translation unit is compiled for.
struct LJMD_SIMD_LEVEL;
using Here = LJMD_SIMD_LEVEL;

/// Vectors as wide as the registers of this level.
using Doubles = Vec<double, register_bytes / 8, Here>;
using Floats = Vec<float, register_bytes / 4, Here>;
#endif

}  // namespace ljmd::simd
