#pragma once

#include <arm_neon.h>

#include <cstdint>

#include "execution/simd_raw.hpp"

/// Instructions of ARM64's NEON for the operations in simd_intrinsics.hpp, as overloads for the vectors that have one.
/// Other vectors use the portable code there.
namespace ljmd::simd::native {

LJMD_INLINE RawVector<double, 2> square_root(RawVector<double, 2> x) {
    return vsqrtq_f64(x);
}
LJMD_INLINE RawVector<float, 4> square_root(RawVector<float, 4> x) {
    return vsqrtq_f32(x);
}
LJMD_INLINE RawVector<float, 4> multiply_add(RawVector<float, 4> a, RawVector<float, 4> b, RawVector<float, 4> c) {
    return vfmaq_f32(c, a, b);
}
// Not vmaxq: where a number is NaN that gives NaN, and the second operand is wanted.
LJMD_INLINE RawVector<double, 2> larger(RawVector<double, 2> a, RawVector<double, 2> b) {
    return vbslq_f64(vcgtq_f64(a, b), a, b);
}
LJMD_INLINE RawVector<float, 4> larger(RawVector<float, 4> a, RawVector<float, 4> b) {
    return vbslq_f32(vcgtq_f32(a, b), a, b);
}
LJMD_INLINE RawVector<float, 4> smaller(RawVector<float, 4> a, RawVector<float, 4> b) {
    return vbslq_f32(vcltq_f32(a, b), a, b);
}
LJMD_INLINE RawVector<double, 4> widened(RawVector<float, 4> x) {
    const RawVector<double, 2> low = vcvt_f64_f32(vget_low_f32(x));
    const RawVector<double, 2> high = vcvt_high_f64_f32(x);
    return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
// There is no instruction that takes the sign of each lane: the lanes' bits are added.
LJMD_INLINE unsigned bits_of_less(RawVector<float, 4> a, RawVector<float, 4> b) {
    const RawVector<std::uint32_t, 4> bits{1, 2, 4, 8};
    return vaddvq_u32(vandq_u32(vcltq_f32(a, b), bits));
}

}  // namespace ljmd::simd::native
