#pragma once

#include "execution/simd_raw.hpp"

/// What differs between the level for Intel's processors (LJMD_SIMD_FOR_INTEL) and the one for AVX-512. On these
/// processors a division of eight numbers takes 16 cycles and a square root 31, in which twice as many other
/// instructions could run, and the units that multiply also add. Estimates are good to 14 bits.
#if defined(LJMD_SIMD_FOR_INTEL)
#include <immintrin.h>

namespace ljmd::simd {

inline constexpr bool multipliers_add = true;
inline constexpr bool divisions_are_slow = true;

namespace native {

// With an estimate y and e = 1 - x y^2: 1/sqrt(x) = y (1 + e/2 + 3 e^2/8 + 5 e^3/16 + O(e^4)).
LJMD_INLINE RawVector<double, 8> inverse_root(RawVector<double, 8> x) {
    const RawVector<double, 8> y = _mm512_rsqrt14_pd(x);
    const RawVector<double, 8> e = _mm512_fnmadd_pd(x * y, y, _mm512_set1_pd(1.0));
    const RawVector<double, 8> slope = _mm512_fmadd_pd(e, _mm512_set1_pd(0.3125), _mm512_set1_pd(0.375));
    const RawVector<double, 8> more = _mm512_fmadd_pd(e, slope, _mm512_set1_pd(0.5));
    return _mm512_fmadd_pd(y, e * more, y);
}
LJMD_INLINE RawVector<float, 16> inverse_root(RawVector<float, 16> x) {
    const RawVector<float, 16> y = _mm512_rsqrt14_ps(x);
    const RawVector<float, 16> e = _mm512_fnmadd_ps(x * y, y, _mm512_set1_ps(1.0F));
    return _mm512_fmadd_ps(y * e, _mm512_set1_ps(0.5F), y);
}

}  // namespace native

}  // namespace ljmd::simd
#else
namespace ljmd::simd {

/// Whether the units that multiply also add, so that fusing an addition with a multiplication saves an instruction.
inline constexpr bool multipliers_add = false;

/// Whether a division in double takes as long as ten multiplications or more.
inline constexpr bool divisions_are_slow = false;

}  // namespace ljmd::simd
#endif
