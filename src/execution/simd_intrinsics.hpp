#pragma once

#include <cstdint>
#include <utility>

#include "execution/simd_intel.hpp"
#include "execution/simd_raw.hpp"

namespace ljmd::simd::native {

/// Placeholder argument: the names below need one overload each, also on processors without native ones.
struct None {};
void keep_where(None);
void larger(None);
void smaller(None);
void multiply_add(None);
void square_root(None);
void widened(None);
void joined(None);
void inverse_root(None);
void bits_of_less(None);
void pack(None);
void repeated(None);
void each_repeated(None);

}  // namespace ljmd::simd::native

#if defined(__x86_64__)
#include "execution/simd_x86.hpp"
#elif defined(LJMD_SIMD_NEON)
#include "execution/simd_neon.hpp"
#endif

/// Operations that the compilers' vector extension lacks: one instruction where the processor has it, else portable
/// code.
namespace ljmd::simd {

/// a b + c, in double precision rounded twice, so that all levels have the same bits; in single precision once, where
/// there is an instruction for it. The level for Intel's processors, which has bits of its own, rounds once.
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> multiply_add(RawVector<T, lanes> a, RawVector<T, lanes> b, RawVector<T, lanes> c) {
    if constexpr ((multipliers_add || sizeof(T) < sizeof(double)) && requires { native::multiply_add(a, b, c); }) {
        return native::multiply_add(a, b, c);
    } else {
        return a * b + c;
    }
}

/// Whether the level has a fast 1/sqrt(x): within 2 units in the last place; NaN for 0 and infinity.
template <class T, int lanes>
inline constexpr bool has_inverse_root = requires(RawVector<T, lanes> x) {
    native::inverse_root(x);
};

/// Each lane in double. gcc 12 compiles __builtin_convertvector to a detour through memory.
template <int lanes>
LJMD_INLINE RawVector<double, lanes> widened(RawVector<float, lanes> x) {
    if constexpr (requires { native::widened(x); }) {
        return native::widened(x);
    } else {
        return __builtin_convertvector(x, RawVector<double, lanes>);
    }
}

/// Lanes from `first` on. Copying bytes instead would keep the vector in memory.
template <class T, int lanes, int first, int... lane>
LJMD_INLINE RawVector<T, sizeof...(lane)> lanes_from(RawVector<T, lanes> v, std::integer_sequence<int, lane...>) {
    return __builtin_shufflevector(v, v, (first + lane)...);
}

/// Lower and upper half of a vector.
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes / 2> low_half(RawVector<T, lanes> v) {
    return lanes_from<T, lanes, 0>(v, std::make_integer_sequence<int, lanes / 2>());
}
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes / 2> high_half(RawVector<T, lanes> v) {
    return lanes_from<T, lanes, lanes / 2>(v, std::make_integer_sequence<int, lanes / 2>());
}

/// One vector of two halves.
template <class T, int lanes>
LJMD_INLINE RawVector<T, 2 * lanes> joined(RawVector<T, lanes> low, RawVector<T, lanes> high) {
    if constexpr (requires { native::joined(low, high); }) {
        return native::joined(low, high);
    } else {
        RawVector<T, 2 * lanes> both;
        __builtin_memcpy(&both, &low, sizeof low);
        __builtin_memcpy(reinterpret_cast<char*>(&both) + sizeof low, &high, sizeof high);
        return both;
    }
}

/// Vectors wider than a register are better processed in halves: compilers split their comparisons and roots into
/// single lanes.
template <class T, int lanes>
inline constexpr bool needs_two_registers = lanes > 2 && sizeof(RawVector<T, lanes>) > register_bytes;

/// x in the lanes where a < b, 0 elsewhere, even where x is infinite or NaN.
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> keep_where_less(RawVector<T, lanes> a, RawVector<T, lanes> b, RawVector<T, lanes> x) {
    if constexpr (needs_two_registers<T, lanes>) {
        return joined<T, lanes / 2>(
            keep_where_less<T, lanes / 2>(low_half<T, lanes>(a), low_half<T, lanes>(b), low_half<T, lanes>(x)),
            keep_where_less<T, lanes / 2>(high_half<T, lanes>(a), high_half<T, lanes>(b), high_half<T, lanes>(x)));
    } else if constexpr (requires { native::keep_where(a < b, x); }) {
        return native::keep_where(a < b, x);
    } else {
        using Bits = RawVector<typename Integer<T>::Type, lanes>;
        return reinterpret<RawVector<T, lanes>>((a < b) & reinterpret<Bits>(x));
    }
}

/// Larger one of each lane; b where a is NaN. From operators compilers make a comparison and a selection.
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> larger(RawVector<T, lanes> a, RawVector<T, lanes> b) {
    if constexpr (requires { native::larger(a, b); }) {
        return native::larger(a, b);
    } else if constexpr (needs_two_registers<T, lanes>) {
        return joined<T, lanes / 2>(larger<T, lanes / 2>(low_half<T, lanes>(a), low_half<T, lanes>(b)),
                                    larger<T, lanes / 2>(high_half<T, lanes>(a), high_half<T, lanes>(b)));
    } else {
        return a > b ? a : b;
    }
}

/// Smaller one of each lane; b where a is NaN.
template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> smaller(RawVector<T, lanes> a, RawVector<T, lanes> b) {
    if constexpr (requires { native::smaller(a, b); }) {
        return native::smaller(a, b);
    } else {
        return a < b ? a : b;
    }
}

template <class T, int lanes>
LJMD_INLINE RawVector<T, lanes> square_root(RawVector<T, lanes> x) {
    if constexpr (requires { native::square_root(x); }) {
        return native::square_root(x);
    } else if constexpr (needs_two_registers<T, lanes>) {
        return joined<T, lanes / 2>(square_root<T, lanes / 2>(low_half<T, lanes>(x)),
                                    square_root<T, lanes / 2>(high_half<T, lanes>(x)));
    } else {
        RawVector<T, lanes> result;
        for (int k = 0; k < lanes; ++k) {
            result[k] = static_cast<T>(__builtin_sqrt(x[k]));  // for a float the same as the float root, rounded once
        }
        return result;
    }
}

/// One bit per lane: set where a < b.
template <int lanes>
LJMD_INLINE unsigned bits_of_less(RawVector<float, lanes> a, RawVector<float, lanes> b) {
    if constexpr (requires { native::bits_of_less(a, b); }) {
        return native::bits_of_less(a, b);
    } else {
        unsigned bits = 0;
        for (int k = 0; k < lanes; ++k) {
            bits |= a[k] < b[k] ? 1U << k : 0U;
        }
        return bits;
    }
}

/// Write numbers whose bit is set to consecutive places, of every `step`-th lane.
/// @param bits  one per lane; only bits of the lanes 0, step, 2 step, ... may be set
/// @return how many  @pre room at `to` for all lanes
template <int lanes, int step>
LJMD_INLINE int pack(const std::int32_t* numbers, unsigned bits, std::int32_t* to) {
    if constexpr (requires(RawVector<std::int32_t, lanes> v) { native::pack(v, bits, to); }) {
        RawVector<std::int32_t, lanes> v;
        __builtin_memcpy(&v, numbers, sizeof v);
        return native::pack(v, bits, to);
    } else {
        int count = 0;
        for (int k = 0; k < lanes;
             k += step) {  // always written, kept if its bit is set: a branch would be mispredicted
            to[count] = numbers[k];
            count += static_cast<int>(bits >> k & 1U);
        }
        return count;
    }
}

/// Two or four numbers, repeated as a whole to fill the vector.
template <class T, int lanes, int count, int... lane>
LJMD_INLINE RawVector<T, lanes> repeated(RawVector<T, count> few, std::integer_sequence<int, lane...>) {
    return __builtin_shufflevector(few, few, (lane % count)...);
}
template <class T, int lanes, int count>
LJMD_INLINE RawVector<T, lanes> repeated(RawVector<T, count> few) {
    if constexpr (lanes == count) {
        return few;
    } else if constexpr (requires { native::repeated(few, RawVector<T, lanes>{}); }) {
        return native::repeated(few, RawVector<T, lanes>{});
    } else {
        return repeated<T, lanes, count>(few, std::make_integer_sequence<int, lanes>());
    }
}

/// Two or four numbers, each repeated in consecutive lanes. With gcc 12 the portable code goes through memory.
template <class T, int lanes, int count, int... lane>
LJMD_INLINE RawVector<T, lanes> each_repeated(RawVector<T, count> few, std::integer_sequence<int, lane...>) {
    return __builtin_shufflevector(few, few, (lane / (lanes / count))...);
}
template <class T, int lanes, int count>
LJMD_INLINE RawVector<T, lanes> each_repeated(RawVector<T, count> few) {
    if constexpr (requires { native::each_repeated(few, RawVector<T, lanes>{}); }) {
        return native::each_repeated(few, RawVector<T, lanes>{});
    } else {
        return each_repeated<T, lanes, count>(few, std::make_integer_sequence<int, lanes>());
    }
}

}  // namespace ljmd::simd
